"""Forbids system calls that no answer needs, by libseccomp, which most Linux machines have through
systemd. Without it, isolation rests on the namespaces alone.

It is called through ctypes: its own Python binding is not on PyPI, and the one that is
(pyseccomp) has had no release since 2021.
"""

import ctypes
import errno
import functools
import tempfile
from typing import Any

FORBIDDEN = (
    "add_key", "keyctl", "request_key", "ptrace", "process_vm_readv", "process_vm_writev",
    "process_madvise", "pidfd_getfd", "kcmp", "unshare", "setns", "mount", "umount2",
    "pivot_root", "chroot", "open_tree", "move_mount", "fsopen", "fsconfig", "fsmount",
    "fspick", "mount_setattr", "name_to_handle_at", "open_by_handle_at", "bpf",
    "perf_event_open", "userfaultfd", "io_uring_setup", "io_uring_enter", "io_uring_register",
    "memfd_create", "memfd_secret", "shmget", "shmat", "msgget", "semget", "mq_open",
    "init_module", "finit_module", "delete_module", "kexec_load", "kexec_file_load", "reboot",
    "swapon", "swapoff", "acct", "quotactl", "syslog", "lookup_dcookie", "iopl", "ioperm",
    "modify_ldt", "fanotify_init",
    "setsid",  # the scheduler shares the processor among sessions: one submission is one
)  # fmt: skip
NEW_USER_NAMESPACE = 0x10000000
LAST_FAMILY = 10  # AF_INET6; socket families beyond are netlink, AF_ALG, AF_VSOCK to the host
_ALLOW, _ERRNO = 0x7FFF0000, 0x00050000
_GREATER, _MASKED_EQUAL = 6, 7
_PR_SET_SECCOMP, _FILTER, _INSTRUCTION = 22, 2, 8  # the last in bytes


class _Comparison(ctypes.Structure):
    _fields_ = (
        ("argument", ctypes.c_uint),
        ("operator", ctypes.c_int),
        ("a", ctypes.c_uint64),
        ("b", ctypes.c_uint64),
    )


class _Program(ctypes.Structure):
    _fields_ = (("length", ctypes.c_ushort), ("instructions", ctypes.c_char_p))


@functools.cache
def library() -> Any:
    """libseccomp, or None where it is not installed; first called before the root is changed."""
    try:
        found = ctypes.CDLL("libseccomp.so.2")
    except OSError:
        return None
    found.seccomp_init.restype = ctypes.c_void_p
    return found


@functools.cache
def program() -> bytes:
    """The filter as the kernel takes it, b"" without the library; made once, by the worker."""
    if library() is None:
        return b""
    context = ctypes.c_void_p(library().seccomp_init(ctypes.c_uint32(_ALLOW)))
    for name in FORBIDDEN:
        _add(context, name, errno.EPERM)
    user = NEW_USER_NAMESPACE
    _add(context, "clone", errno.EPERM, _Comparison(0, _MASKED_EQUAL, user, user))
    # clone3 has its flags in memory, which a filter cannot read; the C library falls back to clone
    _add(context, "clone3", errno.ENOSYS)
    _add(context, "socket", errno.EPERM, _Comparison(0, _GREATER, LAST_FAMILY, 0))
    with tempfile.TemporaryFile() as f:
        failed = library().seccomp_export_bpf(context, f.fileno())
        library().seccomp_release(context)
        f.seek(0)
        made = f.read()
    if failed or not made:
        raise OSError(-failed, "libseccomp failed to make a filter of system calls")
    return made


def forbid() -> bool:
    """Make the calls fail in this process and its children; False without the library. The process
    must have given up new privileges (NO_NEW_PRIVS).
    """
    if not program():
        return False
    filled = _Program(len(program()) // _INSTRUCTION, program())
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.prctl(_PR_SET_SECCOMP, _FILTER, ctypes.byref(filled), 0, 0):
        raise OSError(ctypes.get_errno(), "the kernel refuses a filter of system calls")
    return True


def _add(context: ctypes.c_void_p, name: str, error: int, *comparisons: _Comparison) -> None:
    number = library().seccomp_syscall_resolve_name(name.encode())
    if number < 0:  # a call that this machine or the library does not have
        return
    array = (_Comparison * len(comparisons))(*comparisons)
    library().seccomp_rule_add_array(
        context, ctypes.c_uint32(_ERRNO | error), number, len(comparisons), array
    )
