"""Text that somebody else wrote, for the terminal and for pictures; and what is said on stderr."""
import sys
import unicodedata

LONGEST_TITLE = 120  # letters of a picture's title; a longer one would make the picture as wide


def is_harmful(letter):
    """Control characters, among them line ends and the start of escape sequences, marks that turn the direction of writing,
    and halves of characters."""
    return unicodedata.category(letter) in ("Cc", "Cs", "Zl", "Zp") or letter in "\u061c\u200e\u200f\ufeff" or \
        "\u202a" <= letter <= "\u202e" or "\u2066" <= letter <= "\u2069"


def escape(letter):
    if letter in "\n\r\t":
        return {"\n": "\\n", "\r": "\\r", "\t": "\\t"}[letter]
    if "\udc80" <= letter <= "\udcff":  # a byte of a file name that is no UTF-8
        return f"\\x{ord(letter) - 0xdc00:02x}"
    return f"\\x{ord(letter):02x}" if ord(letter) < 0x80 else f"\\u{ord(letter):04x}"


def printable(text):
    """The text on one line, as a terminal may show it."""
    return "".join(escape(letter) if is_harmful(letter) else letter for letter in str(text))


def pictured(text):
    """The same for a picture: not too long, and "$" does not begin a formula."""
    text = printable(text)
    if len(text) > LONGEST_TITLE:
        text = text[:LONGEST_TITLE - 1] + "…"
    return text.replace("$", r"\$")


class PlotError(Exception):
    """What cannot be drawn, and the way out, in one sentence."""


def note(text, said=set()):
    """For what is not drawn although the rest is; each text once."""
    if text not in said:
        said.add(text)
        print(f"note: {text}", file=sys.stderr)
