"""Contains what the checks of this folder share: the root of the project and the reports."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

_findings = []


def report(path, line, found, expected):
    """Records one finding: the place, what was found there and what was expected."""
    _findings.append(f"{path.relative_to(ROOT)}:{line}: {found}; expected: {expected}")


def finish():
    """Prints the findings, each once, and returns the exit status of the check."""
    for finding in dict.fromkeys(_findings):
        print(finding, file=sys.stderr)
    return 1 if _findings else 0


def blanked(pattern, text, flags=0):
    """Returns the text with every match replaced by spaces. Lines keep their places."""
    return re.sub(pattern, lambda match: re.sub(r"[^\n]", " ", match.group()), text, flags=flags)


def line_of(text, position):
    return text.count("\n", 0, position) + 1
