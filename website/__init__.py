"""The course as a site of static pages, built by ``python -m website``.

Imports go down in this list only, and everything below it may import the grader:

    command         the command line
    build           the steps of a build
    languages       the pages of another language, and their links
    translations    what of the course another language has, lacks, or has of an older text
    engine          Python and the engine beside the pages
    formulas        formulas, drawn when the site is built
    npm             packages of npm, fetched once, checked and kept
    contents        the first page
    landing         what a reader can do on it at once
    reference       one page for each room of the engine, and the dictionary of its symbols
    problem_index   all problems in one table, to choose from
    problem_pages   the statements of the problems, with figures; no answers
    practice_sets   the practice of the problem pages
    chapter_pages   an executed notebook made ready for Sphinx
    moving          figures with sliders, which the engine in the page draws
    pictures        pictures within a page as files beside it
    execution       notebooks run in clean kernels, their outputs kept
    notebooks       which chapters there are, in the order of the book
    rendering       the pages by their templates/, in the language that is spoken
    kept            the folder in which results are kept, and what they depend on
    browser         what the pages call in a reader's browser; it imports the engine alone

``theme/`` is Sphinx's configuration with its style sheet, script and template.
"""
