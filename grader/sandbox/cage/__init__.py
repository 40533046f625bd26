"""The process that runs student code. It is started as a script (``__main__.py``) and imports
nothing of ``grader`` or ``exercises``: what is in here may be read by student code.

    __main__   loads this folder as a package named ``cage`` and starts it
    serve      imports libraries once; for each job forks the processes that run it, and ends them
    isolation  namespaces, a root of its own, limits, no privileges
    calls      forbids system calls, where libseccomp is installed
    memory     limits the memory of all processes of a job together
    watch      finds, freezes and kills descendants
    libraries  what student code may import without waiting
    rehearsal  runs a sheet once, so that each submission finds warm what it needs
    cells      runs the cells of a notebook in order, and reads the answers
    shell      what a notebook has besides Python: magics, ``display``, ``_``, top-level ``await``
"""
