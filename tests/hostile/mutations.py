"""Scenes spoilt by lot, with a mind for what a scene is made of: numbers, keys, arrays, types, and the text itself.

A scene is a value of JSON; tokens that Python's writer would not make, and keys that stand twice, are words with a
mark that is taken away once it is text.
"""

import copy
import json
import re

MARK = "\x00"
LARGE = 200000  # bytes; what is as large is spoilt no more
TOKENS = r"""
0 -0 0.0 1e308 -1e308 1e400 -1e400 1e-308 1e-320 -1e-320 5e-324 NaN -NaN Infinity nan "NaN" "1" 9223372036854775807
9223372036854775808 18446744073709551616 -9223372036854775809
1000000000000000000000000000000000000000000000000000000000000 1e60 1e-60 1.0000000000000002 0.9999999999999999
2147483647 2147483648 4294967296 1e30 1e-30 1e6 1e-6 1e15 1e-15 0x10 +1 .5 1. 01 1e true null 1e7 10000001
""".split()
SIZES = (0, 1, 2, 3, 7, 1000, 16384, 16385, 100000, 10**7, 10**7 + 1, 2**31 - 1, 2**31, 2**32, 2**63, -1, 1.5)
WORDS = (
    "",
    " ",
    "mirror",
    "glass",
    "wall",
    "light",
    "sensor",
    "camera",
    "points",
    "from",
    "to",
    "type",
    "material",
    "a" * 5000,
    "/etc/passwd",
    "../x.obj",
    "meshes/none.obj",
    "é",
    "\u202e",
    "\ud83d\ude00",
    "diffuse",
    "dielectric",
    "conductor",
    "segment",
    "mesh",
    "2",
    "nan",
    "{}",
    "%s%n",
    "__proto__",
)


def raw(token):
    return f"{MARK}raw{token}{MARK}"


def text_of(value):
    text = json.dumps(value, indent=1)
    text = re.sub(r'"\\u0000raw((?:[^"\\]|\\.)*?)\\u0000"', lambda m: m.group(1).replace('\\"', '"'), text)
    return re.sub(r"\\u0000twin\d*", "", text)


def places(value, path=()):
    """Every place below a value, as the keys that lead there."""
    yield path
    entries = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, entry in entries:
        yield from places(entry, (*path, key))


def at(value, path):
    for key in path:
        value = value[key]
    return value


def put(value, path, entry):
    at(value, path[:-1])[path[-1]] = entry


def chosen(scene, lot, is_wanted):
    found = [path for path in places(scene) if path and is_wanted(at(scene, path))]
    return lot.choice(found) if found else None


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def is_size(path):
    return any(key in ("bins", "resolution", "max_vertices") for key in path)


# ---- what is done to a scene; each changes it in place


def number_by_token(scene, lot):
    if path := chosen(scene, lot, is_number):
        put(scene, path, raw(lot.choice(TOKENS)))


def number_nearby(scene, lot):
    if path := chosen(scene, lot, is_number):
        old = at(scene, path)
        put(
            scene,
            path,
            lot.choice(
                (
                    -old,
                    old * (1 + 2.3e-16),
                    old * (1 - 1.2e-16),
                    old + 1e-12,
                    old * 1e-9,
                    old * 1e9,
                    old + 1,
                    old - 1,
                    old * 0.5,
                    old * 2,
                    old * 10.0 ** lot.randint(-70, 70),
                    old + lot.gauss(0, 0.1),
                )
            ),
        )


def number_of_another_place(scene, lot):
    here, there = chosen(scene, lot, is_number), chosen(scene, lot, is_number)
    if here:
        put(scene, here, at(scene, there))


def size(scene, lot):
    found = [path for path in places(scene) if path and is_size(path) and is_number(at(scene, path))]
    if found:
        put(scene, lot.choice(found), lot.choice(SIZES))
    else:
        scene["max_vertices"] = lot.choice(SIZES)


def key_removed(scene, lot):
    if path := chosen(scene, lot, lambda value: True):
        del at(scene, path[:-1])[path[-1]]


def key_doubled(scene, lot):
    if (path := chosen(scene, lot, lambda value: True)) and isinstance(path[-1], str):
        put(scene, (*path[:-1], f"{path[-1]}{MARK}twin"), copy.deepcopy(at(scene, path)))


def key_renamed(scene, lot):
    if (path := chosen(scene, lot, lambda value: True)) and isinstance(path[-1], str):
        holder, word = at(scene, path[:-1]), path[-1]
        at_random = lot.randrange(len(word) + 1)
        new = lot.choice(
            (word[:at_random] + "x" + word[at_random:], word.upper(), word[::-1], lot.choice(WORDS), word + " ")
        )
        holder[new] = holder.pop(word)


def key_moved(scene, lot):
    if path := chosen(scene, lot, lambda value: True):
        entry = at(scene, path[:-1]).pop(path[-1])
        if to := chosen(scene, lot, lambda value: isinstance(value, dict)):
            at(scene, to)[str(path[-1])] = entry


def array_changed(scene, lot):
    if path := chosen(scene, lot, lambda value: isinstance(value, list)):
        old = at(scene, path)
        new = lot.choice(
            (
                lambda: [],
                lambda: old[::-1],
                lambda: old + old[-1:],
                lambda: old[:-1],
                lambda: old * 2,
                lambda: old * min(2000, 100000 // (1 + len(json.dumps(old)))),
                lambda: transposed(old),
                lambda: sorted(old, key=json.dumps),
                lambda: [old],
                lambda: old[:1],
            )
        )()
        put(scene, path, copy.deepcopy(new))


def transposed(rows):
    if rows and all(isinstance(row, list) for row in rows):
        return [list(column) for column in zip(*rows)]
    return [[entry] for entry in rows]


def nested(scene, lot):
    if path := chosen(scene, lot, lambda value: True):
        depth = lot.choice((2, 20, 400))
        entry = at(scene, path)
        for _ in range(depth):
            entry = [entry] if depth % 3 else {"a": entry}
        put(scene, path, entry)


def type_exchanged(scene, lot):
    if path := chosen(scene, lot, lambda value: True):
        old = at(scene, path)
        put(
            scene,
            path,
            lot.choice((None, True, 0, 1.5, [], {}, str(old)[:50], [old], {"value": old}, lot.choice(WORDS))),
        )


def word_changed(scene, lot):
    if path := chosen(scene, lot, lambda value: isinstance(value, str)):
        words = [at(scene, p) for p in places(scene) if isinstance(at(scene, p), str)]
        put(scene, path, lot.choice((lot.choice(WORDS), lot.choice(words))))


def spliced(scene, lot):
    here, there = chosen(scene, lot, lambda value: True), chosen(scene, lot, lambda value: True)
    if here:
        put(scene, here, copy.deepcopy(at(scene, there)))


def shapes_repeated(scene, lot):
    """Many more of a shape, a little beside each other."""
    shapes = scene.get("shapes")
    if not isinstance(shapes, list) or not shapes:
        return
    old = lot.choice(shapes)
    count = min(lot.choice((3, 50, 1500)), 400000 // (1 + len(json.dumps(old))))
    for k in range(count):
        new = copy.deepcopy(old)
        for path in list(places(new)):
            if path and is_number(at(new, path)) and not is_size(path):
                put(new, path, at(new, path) + 1e-3 * (k + 1))
        if isinstance(new, dict):
            new.pop("sensor", None)
        shapes.append(new)


MUTATIONS = {
    number_by_token: 6,
    number_nearby: 8,
    number_of_another_place: 4,
    size: 3,
    key_removed: 3,
    key_doubled: 1,
    key_renamed: 1,
    key_moved: 2,
    array_changed: 3,
    nested: 1,
    type_exchanged: 2,
    word_changed: 3,
    spliced: 4,
    shapes_repeated: 2,
}


def text_spoilt(text, lot):
    data = bytearray(text.encode("utf-8", "surrogatepass"))
    where = lot.randrange(len(data))
    how = lot.randrange(6)
    if how == 0:
        del data[where:]
    elif how == 1:
        data[where:where] = bytes([lot.randrange(256)])
    elif how == 2:
        data[where] = lot.choice(b'{}[],:"\\-+0e\x00\xff\xc3')
    elif how == 3:
        data[:0] = lot.choice(
            (b"\xef\xbb\xbf", b"\xff\xfe", b"[" * 100000, b"// " + 500000 * b"x" + b"\n", b"/*", b"\n" * 100000)
        )
    elif how == 4:
        data += lot.choice((b"}", b"{}", b"\x00", b"//", b"/*", 900000 * b" ", b"null"))
    else:
        end = min(len(data), where + lot.randrange(1, 40))
        data[where:where] = data[where:end]
    return bytes(data)


def hostile(scene, lot):
    """The bytes of a scene that was spoilt at one to four places, and the names of what was done."""
    scene, done = copy.deepcopy(scene), []
    text = text_of(scene)
    for mutation in lot.choices(list(MUTATIONS), MUTATIONS.values(), k=lot.choice((1, 1, 1, 2, 2, 3, 4))):
        if not isinstance(scene, dict) or not scene or len(text) > LARGE:
            break
        mutation(scene, lot)
        done.append(mutation.__name__)
        text = text_of(scene)
    if lot.random() < 0.06:
        return text_spoilt(text, lot), [*done, "text_spoilt"]
    return text.encode("utf-8", "surrogatepass"), done
