"""The course as a site of static pages, built by ``python -m website``.

Imports go down in this list only, and everything below it may import the grader:

    command         the command line
    build           the steps of a build
    languages       the pages of another language, and links to them
    translations    what of the course is translated, missing or stale in another language
    engine          Python and the engine beside the pages
    formulas        formulas, typeset when the site is built
    npm             packages of npm, fetched once, checked and cached
    contents        the first page
    landing         the interactive part of it
    reference       a page for each room of the engine, and the dictionary of its symbols
    problem_index   all problems in one table
    problem_pages   the statements of the problems, with figures; no answers
    practice_sets   the practice files of the problem pages
    chapter_pages   an executed notebook, prepared for Sphinx
    moving          figures with sliders, drawn by the engine in the page
    pictures        embedded pictures as separate files
    execution       notebooks run in clean kernels, their outputs cached
    notebooks       the chapters, in the order of the book
    rendering       pages from templates/, in the language of the site
    kept            the cache, with names that change with all that a result depends on
    browser         what the pages call in a reader's browser; imports the engine alone

``theme/`` is Sphinx's configuration with style sheets and scripts.
"""
