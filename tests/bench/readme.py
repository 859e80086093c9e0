"""The part of the README that a measurement writes: what stands between two comments."""

BEGIN, END = "<!-- tests/bench/run --readme writes from here -->", "<!-- to here -->"


def replaced(text, table):
    """The README with the table in its place. Raises ValueError unless both comments stand in it once, in order."""
    if text.count(BEGIN) != 1 or text.count(END) != 1 or text.index(BEGIN) > text.index(END):
        raise ValueError(f"the README needs the line '{BEGIN}' and after it '{END}', once each")
    head, tail = text.split(BEGIN)[0], text.split(END)[1]
    return f"{head}{BEGIN}\n\n{table.strip()}\n\n{END}{tail}"
