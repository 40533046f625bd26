"""The isolation of a process: Linux namespaces, a read-only root with the interpreter and its
libraries, resource limits, an unprivileged user, no capabilities, a keyring of its own.
"""

import contextlib
import ctypes
import errno
import functools
import importlib
import os
import platform
import resource
import signal
import sys
import sysconfig

MEMORY = 3 * 2**30  # bytes of address space
PROCESSES = 64
FILE_SIZE = 16 * 2**20  # bytes
TMPFS = "size=64m,nr_inodes=20000"  # inodes too: empty files take memory
CLONE = {
    "mount": 0x20000, "uts": 0x4000000, "ipc": 0x8000000, "user": 0x10000000,
    "pid": 0x20000000, "net": 0x40000000,
}  # fmt: skip
MS_RDONLY, MS_NOSUID, MS_NODEV, MS_REMOUNT = 1, 2, 4, 32
MS_BIND, MS_REC, MS_PRIVATE = 4096, 16384, 1 << 18
MS_NOEXEC, MS_NOATIME, MS_RELATIME = 8, 1024, 1 << 21
MNT_DETACH = 2
KEYCTL_JOIN_SESSION_KEYRING = 1
PR_SET_DUMPABLE, PR_CAPBSET_DROP, PR_SET_NO_NEW_PRIVS = 4, 24, 38
SYSCALLS = {  # numbers of the calls that the C library does not offer
    "x86_64": {"clone": 56, "pivot_root": 155, "keyctl": 250},
    "aarch64": {"clone": 220, "pivot_root": 41, "keyctl": 219},
}
NOBODY = 65534


class Refused(OSError):
    """The kernel does not allow a namespace, a mount, or a limit."""


def _libc():
    return ctypes.CDLL(None, use_errno=True)


def _call(function, *args):
    if function(*args) != 0:
        raise _refusal()


def _refusal(what=""):
    error = ctypes.get_errno()
    return Refused(error, what + os.strerror(error))


def _syscall(name):
    try:
        return SYSCALLS[platform.machine()][name]
    except KeyError:
        raise Refused(0, f"the number of {name} on {platform.machine()} is not known") from None


def fork_into_namespaces() -> int:
    """``os.fork``, but the child is the first process of new namespaces, which it has to claim
    (:func:`claim_namespaces`).

    ``unshare`` would need one more process, since it does not change the pid namespace of its
    caller. Python has no clone: called directly, it needs the interpreter's hooks around it, as in
    ``os.fork``.
    """
    if sys.platform != "linux":
        raise Refused(0, f"{sys.platform} has no namespaces")
    number, python = _syscall("clone"), ctypes.pythonapi
    if (threads := len(os.listdir("/proc/self/task"))) > 1:
        # unlike fork, clone runs no handlers of the libraries: some would wait for their threads
        raise Refused(0, f"a library has started {threads - 1} threads in the worker")
    kinds = [k for k in CLONE if k != "user" or os.geteuid() != 0]
    call = ctypes.PyDLL(None, use_errno=True).syscall  # PyDLL keeps the interpreter's lock
    python.PyOS_BeforeFork()
    pid = call(number, sum(CLONE[k] for k in kinds) | signal.SIGCHLD, None, None, None, None)
    if pid == 0:
        python.PyOS_AfterFork_Child()
        return 0
    python.PyOS_AfterFork_Parent()
    if pid < 0:
        raise _refusal()
    return pid


def claim_namespaces(uid: int, gid: int) -> None:
    """In the first process, before anything else: keep the ids that it had outside.

    Root makes no user namespace, so there is nothing to claim.
    """
    if uid != 0:
        proc = open_proc()
        _map_user(proc, uid, gid)
        os.close(proc)


def join_keyring() -> None:
    """Join a new session keyring: the instructor's is readable by every process that has it."""
    number = SYSCALLS.get(platform.machine(), {}).get("keyctl")
    if sys.platform != "linux" or number is None:
        return  # no keyrings; a machine that is not in SYSCALLS is refused its namespaces
    failed = _libc().syscall(number, KEYCTL_JOIN_SESSION_KEYRING, None) < 0
    if failed and ctypes.get_errno() != errno.ENOSYS:  # a kernel without keyrings
        raise _refusal("cannot join a new keyring: ")


def forbid_shared_memory() -> None:
    """In the new ipc namespace: no System V segments and queues, whose memory no process owns.
    Where the kernel refuses this, seccomp and the limits on mapped memory remain.
    """
    for name in ("shmmni", "msgmni"):
        with contextlib.suppress(OSError), open(f"/proc/sys/kernel/{name}", "w") as f:
            f.write("0")


def open_proc() -> int:
    """A descriptor of /proc, to write there once the new root, which has none, is entered."""
    return os.open("/proc", os.O_PATH | os.O_DIRECTORY)


def forbid_user_namespaces(proc: int) -> None:
    """Enter a user namespace in which no other can be made, and which has no rights over the first
    process, although that has the same user; closes ``proc``.
    """
    libc, ids = _libc(), (os.geteuid(), os.getegid())
    libc.prctl(PR_SET_DUMPABLE, 1, 0, 0, 0)  # otherwise its own files in /proc belong to root
    _call(libc.unshare, CLONE["user"])
    _map_user(proc, *ids)
    _write(proc, "sys/user/max_user_namespaces", "0")
    os.close(proc)


def _map_user(proc, uid, gid):
    """In a new user namespace, keep the ids; without a map they would be "nobody"."""
    _write(proc, "self/setgroups", "deny")
    _write(proc, "self/uid_map", f"{uid} {uid} 1")
    _write(proc, "self/gid_map", f"{gid} {gid} 1")


def _write(folder, path, text):
    fd = os.open(path, os.O_WRONLY, dir_fd=folder)
    try:
        os.write(fd, text.encode())
    finally:
        os.close(fd)


# -- the root


SYSTEM = (
    "/usr/lib", "/usr/lib64", "/usr/local/lib", "/lib", "/lib64", "/etc/ld.so.cache",
    "/usr/share/zoneinfo",
)  # fmt: skip


@functools.cache
def readable_places() -> tuple[list[str], list[tuple[str, str]]]:
    """(places, links) that student code may read: interpreter, installed libraries, engine,
    chapters; never the course or the exercises. Looked up once in a worker.
    """
    wanted = [path for path in (*_course_material(), *SYSTEM, *_python()) if os.path.exists(path)]
    places: list[str] = []
    for place in sorted({os.path.realpath(p) for p in wanted}, key=len):
        if place != "/" and not any(place == f or place.startswith(f + "/") for f in places):
            places.append(place)
    return places, [(p, os.path.realpath(p)) for p in wanted if os.path.islink(p)]


def _course_material() -> list[str]:
    """The folders of the engine and of its chapters, which are beside it in a checkout."""
    engine = os.path.abspath(str(importlib.import_module("newton_euler").__file__))
    chapters = importlib.import_module("newton_euler.chapters").__path__
    return [os.path.dirname(engine), *chapters]


def _python() -> list[str]:
    """The libraries of Python; whole prefixes would include /usr/local/share/nbgrader/exchange."""
    prefixes = (sys.base_prefix, sys.prefix, sys.base_exec_prefix, sys.exec_prefix)
    return [
        *(os.path.join(prefix, lib) for prefix in prefixes for lib in ("lib", "lib64")),
        *(sysconfig.get_paths()[n] for n in ("stdlib", "platstdlib", "purelib", "platlib")),
        *(p for p in sys.path if os.path.basename(p) in ("site-packages", "dist-packages")),
    ]


def _mount(libc, source, target, kind, flags, data=None):
    text = [x.encode() if isinstance(x, str) else x for x in (source, target, kind, data)]
    _call(libc.mount, text[0], text[1], text[2], ctypes.c_ulong(flags), text[3])


def build_root() -> None:
    """Make a root on tmpfs with the readable places and nothing else, and change to it."""
    libc = _libc()
    places, links = readable_places()
    _mount(libc, None, "/", None, MS_REC | MS_PRIVATE)
    root = _mount_point(places)
    _mount(libc, "cage", root, "tmpfs", MS_NOSUID | MS_NODEV, TMPFS + ",mode=755")
    os.makedirs(root + "/tmp")  # before the places, since one of them may be in it
    _mount(libc, "scratch", root + "/tmp", "tmpfs", MS_NOSUID | MS_NODEV, TMPFS + ",mode=1777")
    for place in places:
        _show(libc, place, root + place, MS_REC)
        flags = MS_BIND | MS_REMOUNT | MS_RDONLY | MS_NOSUID | _kept_flags(place)
        _mount(libc, None, root + place, None, flags)
    for link, real in links:
        with contextlib.suppress(FileExistsError):
            os.makedirs(os.path.dirname(root + link), exist_ok=True)
            os.symlink(real, root + link)
    for device in ("/dev/null", "/dev/zero", "/dev/urandom"):
        _show(libc, device, root + device)
    os.makedirs(root + "/.old")
    _call(libc.syscall, _syscall("pivot_root"), root.encode(), (root + "/.old").encode())
    os.chdir("/")
    _call(libc.umount2, b"/.old", MNT_DETACH)
    os.rmdir("/.old")
    _mount(libc, None, "/", None, MS_BIND | MS_REMOUNT | MS_RDONLY | MS_NOSUID | MS_NODEV)
    os.chdir("/tmp")


def _show(libc, place, target, flags=0):
    """Make a folder or a file visible under ``target``."""
    if os.path.isdir(place):
        os.makedirs(target, exist_ok=True)
    else:
        os.makedirs(os.path.dirname(target), exist_ok=True)
        open(target, "w").close()
    _mount(libc, place, target, None, MS_BIND | flags)


def _mount_point(places):
    """An existing folder outside all places, to mount the new root on."""
    for folder in ("/mnt", "/srv", "/media", "/opt", "/var/tmp", "/tmp"):
        if os.path.isdir(folder) and not any((p + "/").startswith(folder + "/") for p in places):
            return folder
    raise Refused(
        errno.ENOENT,
        "no folder to mount the cage on: all of /mnt, /srv, /media, /opt, /var/tmp and /tmp "
        "hold parts of Python",
    )


def _kept_flags(place):
    """The flags of the mount that a remount in a user namespace must keep."""
    flags, kept = os.statvfs(place).f_flag, 0
    for status, mount in (
        (os.ST_NODEV, MS_NODEV), (os.ST_NOEXEC, MS_NOEXEC),
        (os.ST_NOATIME, MS_NOATIME), (os.ST_RELATIME, MS_RELATIME),
    ):  # fmt: skip
        kept |= mount if flags & status else 0
    return kept


# -- limits and privileges


def limit(seconds: float, used: int, tests: int = 0) -> None:
    """Limit time, memory beyond the ``used`` bytes, files, and processes besides ``tests``."""
    for what, value in (
        (resource.RLIMIT_CPU, int(seconds) + 1),
        (resource.RLIMIT_AS, used + MEMORY),
        (resource.RLIMIT_FSIZE, FILE_SIZE),
        (resource.RLIMIT_NOFILE, 64 + tests),
        (resource.RLIMIT_NPROC, PROCESSES + tests),
        (resource.RLIMIT_CORE, 0),
    ):
        hard = resource.getrlimit(what)[1]
        value = value if hard == resource.RLIM_INFINITY else min(value, hard)
        resource.setrlimit(what, (value, value))


def memory_in_use() -> int:
    """The bytes of address space of this process; 0 where there is no /proc, as on macOS."""
    try:
        with open("/proc/self/statm") as f:
            return int(f.read().split()[0]) * resource.getpagesize()
    except OSError:
        return 0


def become(uid: int) -> None:
    """Become this user, if the process runs as root."""
    if os.geteuid() == 0:
        os.setgroups([])
        try:
            os.setresgid(uid, uid, uid)
            os.setresuid(uid, uid, uid)
        except OSError:  # only a few users are mapped, as in some containers
            os.setresgid(NOBODY, NOBODY, NOBODY)
            os.setresuid(NOBODY, NOBODY, NOBODY)


def drop_capabilities() -> None:
    """Give up all capabilities for good, and those of programs that are started: the creator of a
    user namespace has all of them in it and could make the mounts writable again.
    """
    if sys.platform != "linux":
        return
    libc = _libc()
    for capability in range(64):
        libc.prctl(PR_CAPBSET_DROP, capability, 0, 0, 0)
    _call(libc.capset, (ctypes.c_uint32 * 2)(0x20080522, 0), (ctypes.c_uint32 * 6)())
    libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)


def close_all_but(*kept: int) -> None:
    """Close all descriptors except the standard ones and the given ones."""
    low = 3
    for fd in sorted(kept):
        os.closerange(low, fd)
        low = fd + 1
    os.closerange(low, 1024)
