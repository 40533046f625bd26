"""What a process can do to the machine: kill, outlive, fill, lock, connect, read what is not its own."""

from tests.grader.attacks.attack import code, edited, filled

EVERYONE = """
    import os, signal
    for target in (1, -1, 0, os.getppid(), os.getpgid(0) * -1):
        try: os.kill(target, signal.{signal})
        except OSError: pass
    speed = acc_mag = 1
"""

PROCESSES = {
    "kills everyone": code(EVERYONE.format(signal="SIGKILL")),
    "stops everyone": code(EVERYONE.format(signal="SIGSTOP")),
    "interrupts everyone": code(EVERYONE.format(signal="SIGINT")),
    "leaves threads": code("""
        import threading, time
        for _ in range(8): threading.Thread(target=time.sleep, args=(1000,)).start()
        speed = acc_mag = 1
    """),
    "closes all files": code("import os; os.closerange(0, 1000)"),
    "replaces itself": code("""
        import os, sys
        os.execv(sys.executable, [sys.executable, "-c", "import time; time.sleep(1000)"])
    """),
    "traces the others": code("""
        import ctypes
        libc = ctypes.CDLL(None)
        for pid in range(1, 400):
            libc.ptrace(16, pid, 0, 0), libc.kill(pid, 9) if pid > 50 else None
    """),
}

RESOURCES = {
    # without a cage its files stay, within the limit of each
    "the disk": code("""
        n = 0
        while True:
            open(f'/tmp/$MARK-{n}', 'wb').write(bytes(2**22)); n += 1
    """, caged=True),
    "output": code("while True: print('x' * 10**6)"),
    "its limits": code("""
        import resource
        for what in range(16):
            try: resource.setrlimit(what, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
            except (OSError, ValueError): pass
        x = bytearray(2**40)
    """),
    "the priority": code("""
        import os
        for change in (lambda: os.nice(-20), lambda: os.sched_setscheduler(0, 1, os.sched_param(99)),
                       lambda: os.sched_setaffinity(1, {0})):
            try: change()
            except OSError: pass
        while True: pass
    """),
    "shared memory": code("""
        import ctypes, os
        libc = ctypes.CDLL(None)
        for key in range(0x4d2000, 0x4d2040):
            libc.shmget(key, 2**20, 0o1666), libc.msgget(key, 0o1666), libc.semget(key, 1, 0o1666)
        try: open("/dev/shm/$MARK", "wb").write(bytes(2**20))
        except OSError: pass
    """, caged=True),
    "a keyring": code("""
        import ctypes
        call = ctypes.CDLL(None).syscall
        for ring in (-2, -3, -4, -5):
            call(248, b"user", b"$MARK", b"x", 1, ring)  # add_key
        call(250, 3, -3)  # KEYCTL_REVOKE of the session's
    """),
}  # fmt: skip

ELSEWHERE = {
    "the network": code("""
        import socket
        for family, address in ((socket.AF_INET, ("127.0.0.1", $PORT)),
                                (socket.AF_INET6, ("::ffff:127.0.0.1", $PORT)),
                                (socket.AF_UNIX, "\\0host-$MARK")):
            try: socket.socket(family).connect(address)
            except OSError: pass
    """, caged=True),
    "an abstract socket": code("""
        import os, socket, time
        s = socket.socket(socket.AF_UNIX)
        s.bind("\\0$MARK")
        s.listen()
        if os.fork() == 0: time.sleep(1000)
    """),
    "the solutions": code("""
        import sys
        sys.path[:0] = ["$REPOSITORY", "$COURSE"]
        from exercises.catalogue import problem
        p = problem("4/1")
        for name, value in p.solve({n: globals()[n] for n in p.givens}).items():
            globals()[name] = float(value)
    """, caged=True),
    "the course": code("""
        import os
        found = []
        for place in ("$COURSE", "$HONEST", "$COURSE/.course_secret", "$COURSE/scores",
                      "$COURSE/gradebook.db", "$COURSE/numbers"):
            try: found.append(open(place).read(1000) if os.path.isfile(place) else os.listdir(place))
            except OSError: pass
        raise ValueError(found)
    """, shown=": []"),
    "keys in memory": code("""
        import gc, sys
        frame = sys._getframe()
        while frame:
            for held in (frame.f_locals, frame.f_globals):
                for name in ("key", "answers", "values", "secret"):
                    if isinstance(held.get(name), dict): globals().update(held[name])
            frame = frame.f_back
        for x in gc.get_objects():
            if isinstance(x, dict) and "acc_mag" in x and "speed" in x and x is not globals():
                if x["speed"]: speed, acc_mag = x["speed"], x["acc_mag"]
    """),
    "what others left": code("""
        import os
        found = [os.path.join(f, n) for f in ("/tmp", "/var/tmp", "/dev/shm", "/dev/mqueue")
                 if os.path.isdir(f) for n in os.listdir(f)]
        raise ValueError([p for p in found if os.path.isfile(p)])
    """, shown=": []", caged=True),
    "files of the instructor": code("""
        import os
        for place in ("$OUTSIDE/written", "$COURSE/written", "$COURSE/scores/ch04/written.json",
                      os.path.expanduser("~/written"), "/written", "/etc/written"):
            try:
                os.makedirs(os.path.dirname(place), exist_ok=True)
                open(place, "w").write("x")
            except OSError: pass
        speed = acc_mag = 1
    """),
    "locks on the gradebook": code("""
        import fcntl, os, sqlite3, time
        for place in ("$COURSE/gradebook.db", "$COURSE/scores/.lock", "$COURSE"):
            try: fcntl.flock(os.open(place, os.O_RDWR | os.O_CREAT), fcntl.LOCK_EX)
            except OSError: pass
        try: sqlite3.connect("$COURSE/gradebook.db").execute("BEGIN EXCLUSIVE")
        except sqlite3.Error: pass
        if os.fork() == 0: time.sleep(1000)
        speed = acc_mag = 1
    """),
    "a shell": edited(lambda notebook, scene: [
        c.update(source=filled(
            "!touch $OUTSIDE/shell\n%%bash\ntouch $OUTSIDE/bash" if n % 2 else
            "%%bash\ntouch $OUTSIDE/bash", scene))
        for n, c in enumerate(notebook["cells"]) if c["id"].startswith("answer")] and None),
    "programs": code("""
        import os, subprocess
        for command in (["/bin/sh", "-c", "touch $OUTSIDE/sh"], ["/usr/bin/sudo", "-n", "true"],
                        ["/usr/bin/passwd"], ["/bin/mount"]):
            try: subprocess.run(command, timeout=1)
            except (OSError, subprocess.SubprocessError): pass
        os.system("touch $OUTSIDE/system")
    """),
}  # fmt: skip

ATTACKS = {**PROCESSES, **RESOURCES, **ELSEWHERE}
