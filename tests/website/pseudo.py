"""A pseudo-language: English in full-width letters, so that text that bypasses the catalogue
stands out.
"""

import html
import json
import re

WIDE = {n: n + 0xFEE0 for n in map(ord, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")}
# values, formulas, code, addresses and tags, which a translator leaves
KEPT = re.compile(r"\{[\w.]+\}|\$[^$]*\$|`[^`]*`|\]\([^)]*\)|<[^>]*>|&\w+;")
# what no reader reads as words, in HTML and in Markdown
SILENT = re.compile(
    r"(?s)<(style|script|svg|math|code|pre)\b.*?</\1>|```.*?```|\$[^$]*\$|`[^`]*`|\]\([^)]*\)"
    r"|\\\(.*?\\\)|data:[\w/+;=,]+|\b[\w.]+\(.*?\)|\{[\w.-]+\}|:(?:name|file): \S+|\([\w-]+\)=|(?m:^orphan: true$|^\S+ <\S+>$|^\w+/\S+$)"
)
READ = re.compile(r'(?:alt|aria-label|title|placeholder)="([^"]*)"')


def wide(text):
    """An English text in that language."""
    kept = KEPT.findall(text)
    parts = [part.translate(WIDE) for part in KEPT.split(text)]
    return "".join(a + b for a, b in zip(parts, [*kept, ""], strict=True))


def catalogue(path, sentences):
    """Write the catalogue of that language; ``sentences``: {English: (itself, its plural)}."""
    quoted = lambda text: json.dumps(text, ensure_ascii=False)
    blocks = ['msgid ""\nmsgstr ""\n"Plural-Forms: nplurals=2; plural=(n != 1);\\n"']
    for text, forms in sentences.items():
        lines = [f"msgstr[{n}] {quoted(wide(form))}" for n, form in enumerate(forms)]
        lines = lines if len(forms) > 1 else [f"msgstr {quoted(wide(text))}"]
        blocks.append("\n".join([f"msgid {quoted(text)}", *lines]))
    path.write_text("\n\n".join(blocks) + "\n", "utf-8")


def bare(text, names=()):
    """The English words of what a reader is shown, but for ``names``."""
    text = html.unescape(text)
    attributes = " . ".join(READ.findall(SILENT.sub(" ", text)))
    visible = re.sub(r"<[^>]*>", " ", SILENT.sub(" ", text)) + " . " + attributes
    words = re.findall(r"(?<![\w.\\])[A-Za-z]{3,}(?![\w(])", visible)
    return [word for word in words if word not in names]
