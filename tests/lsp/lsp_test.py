#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The language server, spoken to as an editor does. usage: lsp_test.py PROGRAM [NAME...]"""

import json
import os
import subprocess
import sys
import tempfile

from client import Client

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
URI = "file:///nowhere/a.scene"
GOOD = """PerspectiveCamera {
    center 0 0 5
    direction 0 0 -1
    up 0 1 0
    angle 30
}
Lights {
    DirectionalLight {
        direction 0 0 -1
        color 1 1 1
    }
}
Background {
    color 0 0 0
}
Materials {
    Material red {
        diffuseColor 1 0.5 0
    }
}
Group {
    MaterialIndex 0
    Sphere {
        center 0 0 0
        radius 1
    }
}
"""
DOCUMENT = {"textDocument": {"uri": URI}}


def at(line, character):
    return {"line": line, "character": character}


def applied(text, edits):
    """By code points: the texts here are of one plane."""
    starts = [0]
    for i, c in enumerate(text):
        if c == "\n":
            starts.append(i + 1)

    def offset(position):
        return starts[position["line"]] + position["character"]
    for edit in sorted(edits, key=lambda e: offset(e["range"]["start"]), reverse=True):
        begin, end = offset(edit["range"]["start"]), offset(edit["range"]["end"])
        text = text[:begin] + edit["newText"] + text[end:]
    return text


def expect(what, seen, wanted):
    if seen != wanted:
        raise AssertionError(f"{what}: {seen!r}, and should be {wanted!r}")


def test_life(program):
    client = Client(program)
    expect("before initialize", client.ask("textDocument/hover", **DOCUMENT)["error"]["code"],
           -32002)
    result = client.start()
    able = result["capabilities"]
    expect("encoding", able["positionEncoding"], "utf-16")
    expect("triggers", (able["documentOnTypeFormattingProvider"]["moreTriggerCharacter"],
                        able["signatureHelpProvider"]["triggerCharacters"]), (["\n"], [" "]))
    expect("kinds", able["codeActionProvider"]["codeActionKinds"], ["quickfix", "source.fixAll"])
    expect("again", client.ask("initialize", capabilities={})["error"]["code"], -32600)
    expect("unknown", client.ask("no/such")["error"]["code"], -32601)
    expect("not open", client.ask("textDocument/hover", **DOCUMENT, position=at(0, 0))
           ["error"]["code"], -32803)
    client.open(URI, GOOD)
    expect("no position", client.ask("textDocument/hover", **DOCUMENT)["error"]["code"], -32602)
    client.ask("shutdown")
    expect("after shutdown", client.ask("textDocument/hover", **DOCUMENT)["error"]["code"], -32600)
    client.notify("exit")
    expect("status", client.process.wait(), 0)
    for ending in ("exit", None):
        client = Client(program)
        client.start()
        if ending:
            client.notify("exit")
        client.process.stdin.close()
        expect(f"status after {ending}", client.process.wait(), 1)


def test_bad_messages(program):
    client = Client(program)
    client.start()
    client.send_bytes(b"Content-Length: 3\r\n\r\n{x}")
    expect("no JSON", client.read()["error"]["code"], -32700)
    client.send_bytes(b"Content-Length: x\r\n\r\n")
    expect("no length", client.read()["error"]["code"], -32700)
    for message in ([], 3, {"id": {}, "method": "x"}, {"id": 1, "method": 2}, {"id": 1}):
        client.send(message)
        expect(f"{message}", client.read()["error"]["code"], -32600)
    client.send_bytes(b"content-length:  2 \r\nContent-Type: x\r\n\r\n[]")
    expect("other spelling", client.read()["error"]["code"], -32600)
    # Split anywhere.
    body = json.dumps({"jsonrpc": "2.0", "id": 77, "method": "shutdown"}).encode()
    for byte in b"Content-Length: %d\r\n\r\n" % len(body) + body:
        client.send_bytes(bytes([byte]))
    expect("byte by byte", client.read()["id"], 77)
    client.send_bytes(b"x" * 20000)
    expect("lost", client.read()["error"]["code"], -32700)
    expect("status", client.process.wait(), 1)


def test_findings(program):
    client = Client(program)
    client.start()
    broken = GOOD.replace("angle 30", "angles 30")
    client.open(URI, broken)
    found = client.findings(URI, 1)
    expect("code", [f["code"] for f in found], ["unexpected-argument"])
    expect("range", found[0]["range"], {"start": at(4, 4), "end": at(4, 10)})
    client.change(URI, 2, {"range": {"start": at(4, 9), "end": at(4, 10)}, "text": ""})
    expect("clean", client.findings(URI, 2), [])
    client.change(URI, 3, {"text": broken})
    expect("whole text", len(client.findings(URI, 3)), 1)
    client.change(URI, 5, {"text": GOOD.replace("    Material red", "    Material b {}\n    Material red")})
    unused = [f["tags"] for f in client.findings(URI, 5) if f["code"] == "unused-material"]
    expect("faded", unused, [[1]])
    client.notify("textDocument/didClose", **DOCUMENT)
    expect("closed", client.findings(URI), [])
    expect("status", client.stop(), 0)


def test_units(program):
    """Columns behind a character of two UTF-16 units, four bytes and one code point."""
    line = 17
    text = GOOD.replace("diffuseColor 1 0.5 0", 'texture "\U0001f600.png" diffuseColors 1 0.5 0')
    for unit, column in (("utf-8", 27), ("utf-16", 25), ("utf-32", 24)):
        client = Client(program)
        expect("encoding", client.start([unit])["capabilities"]["positionEncoding"], unit)
        client.open(URI, text)
        places = [f["range"]["start"] for f in client.findings(URI)]
        expect(unit, places, [at(line, 16), at(line, column)])
        end = column + len("diffuseColors")
        client.change(URI, 2, {"range": {"start": at(line, end - 1), "end": at(line, end)},
                               "text": ""})
        expect("only the picture", len(client.findings(URI, 2)), 1)
        if unit == "utf-16":
            # The middle of the character is its beginning, and far past the end is the end.
            client.change(URI, 3, {"range": {"start": at(line, 18), "end": at(line, 19)},
                                   "text": "x"})
            client.change(URI, 4, {"range": {"start": at(line, 99), "end": at(999, 0)},
                                   "text": ""})
            client.findings(URI, 4)
        expect("status", client.stop(), 0)


def test_pull(program):
    client = Client(program)
    result = client.start(textDocument={"diagnostic": {}})
    expect("provider", "diagnosticProvider" in result["capabilities"], True)
    client.open(URI, GOOD.replace("angle 30", "angles 30"))
    first = client.ask("textDocument/diagnostic", **DOCUMENT)["result"]
    expect("kind", (first["kind"], len(first["items"])), ("full", 1))
    again = client.ask("textDocument/diagnostic", **DOCUMENT,
                       previousResultId=first["resultId"])["result"]
    expect("unchanged", again["kind"], "unchanged")
    everywhere = client.ask("workspace/diagnostic", previousResultIds=[])["result"]
    expect("workspace", [i["uri"] for i in everywhere["items"]], [URI])
    expect("status", client.stop(), 0)
    pushed = [m for m in client.messages if m.get("method") == "textDocument/publishDiagnostics"]
    expect("never both", pushed, [])


def test_same_as_lint(program):
    """`data` is what `cobble lint --format json` prints, of every scene there is."""
    client = Client(program)
    client.start()
    scenes = []
    for folder in ("scenes", "tests/cli/cases"):
        for place, _, files in os.walk(os.path.join(ROOT, folder)):
            scenes += [os.path.join(place, name) for name in files if name.endswith(".scene")]
    compared = 0
    for path in sorted(scenes):
        with open(path, "rb") as file:
            data = file.read()
        try:
            text = data.decode()
        except UnicodeDecodeError:
            continue
        run = subprocess.run([program, "lint", "--format", "json", path], capture_output=True,
                             check=False)
        by_file = {f["path"]: f["diagnostics"] for f in json.loads(run.stdout)["files"]}
        uri = "file://" + path
        client.open(uri, text)
        expect(path, [f["data"] for f in client.findings(uri)], by_file[path])
        edits = client.ask("textDocument/formatting", textDocument={"uri": uri},
                           options={})["result"]
        formatted = subprocess.run([program, "fmt", "-"], input=data, capture_output=True,
                                   check=False).stdout
        if text.isascii() and "\r" not in text and formatted:
            expect(f"{path} formatted", applied(text, edits), formatted.decode())
            compared += 1
        client.notify("textDocument/didClose", textDocument={"uri": uri})
    expect("enough were compared", compared > 30, True)
    expect("status", client.stop(), 0)


def test_formatting(program):
    client = Client(program)
    client.start()
    untidy = GOOD.replace("    center 0 0 5\n", "center   0 0 5\n\n\n\n").replace("Group {", "Group{")
    client.open(URI, untidy)
    edits = client.ask("textDocument/formatting", **DOCUMENT, options={})["result"]
    tidy = applied(untidy, edits)
    expect("formatted", tidy, GOOD.replace("center 0 0 5\n", "center 0 0 5\n\n"))
    expect("white space alone", all(not e["newText"].strip() for e in edits), True)
    one = client.ask("textDocument/rangeFormatting", **DOCUMENT, options={},
                     range={"start": at(1, 0), "end": at(2, 0)})["result"]
    expect("one line", applied(untidy, one), untidy.replace("center   0 0 5", "    center 0 0 5"))
    typed = client.ask("textDocument/onTypeFormatting", **DOCUMENT, options={}, ch="\n",
                       position=at(2, 0))["result"]
    expect("the line before", typed, one)
    expect("status", client.stop(), 0)


def test_fixes(program):
    client = Client(program)
    client.start()
    client.open(URI, GOOD.replace("angle 30", "angles 30").replace("radius", "Radius"))
    actions = client.ask("textDocument/codeAction", **DOCUMENT, context={"diagnostics": []},
                         range={"start": at(4, 6), "end": at(4, 6)})["result"]
    expect("titles", [a["title"] for a in actions],
           ["write 'angle'", "Fix all that can be fixed safely"])
    text = GOOD.replace("angle 30", "angles 30").replace("radius", "Radius")
    expect("one", applied(text, actions[0]["edit"]["changes"][URI]),
           text.replace("angles", "angle"))
    expect("all", applied(text, actions[1]["edit"]["changes"][URI]), GOOD)
    only = client.ask("textDocument/codeAction", **DOCUMENT, range={"start": at(0, 0), "end": at(0, 0)},
                      context={"diagnostics": [], "only": ["source"]})["result"]
    expect("only", [a["kind"] for a in only], ["source.fixAll"])
    expect("status", client.stop(), 0)


def test_questions(program):
    client = Client(program)
    client.start(textDocument={"completion": {"completionItem": {"snippetSupport": True}}})
    client.open(URI, GOOD)

    def ask(method, **params):
        answer = client.ask("textDocument/" + method, **DOCUMENT, **params)
        if "error" in answer:
            raise AssertionError(f"{method}: {answer['error']}")
        return answer["result"]
    symbols = ask("documentSymbol")
    expect("symbols", [s["name"] for s in symbols],
           ["PerspectiveCamera", "Lights", "Background", "Materials", "Group"])
    expect("their children", [c["name"] for c in symbols[3]["children"]], ["red"])
    folds = ask("foldingRange")
    expect("folds", (folds[0]["startLine"], len(folds) >= 7), (0, True))
    chosen = ask("selectionRange", positions=[at(4, 11)])[0]
    expect("selection", (chosen["range"]["start"], "parent" in chosen), (at(4, 10), True))
    expect("hover", "angle" in ask("hover", position=at(4, 5))["contents"]["value"], True)
    expect("no hover", ask("hover", position=at(0, 19)), None)
    labels = [i["label"] for i in ask("completion", position=at(26, 0))["items"]]
    expect("completion", ("Sphere" in labels, "DirectionalLight" in labels), (True, False))
    signature = ask("signatureHelp", position=at(3, 9))
    expect("signature", signature["activeParameter"], 1)
    data = ask("semanticTokens/full")["data"]
    legend = next(m for m in client.messages if m.get("id") == 1)["result"]["capabilities"][
        "semanticTokensProvider"]["legend"]
    expect("tokens", (data[:3], legend["tokenTypes"][data[3]]), ([0, 0, 17], "camera"))
    part = ask("semanticTokens/range", range={"start": at(4, 0), "end": at(5, 0)})["data"]
    expect("two tokens", (len(part), part[:3]), (10, [4, 4, 5]))
    colors = ask("documentColor")
    expect("colours", [c["color"]["green"] for c in colors], [1, 0, 0.5])
    texts = [p["label"] for p in ask("colorPresentation", color=colors[2]["color"],
                                     range=colors[2]["range"])]
    expect("presentations", texts, ["1 0.5 0", "#ff8000"])
    expect("definition", ask("definition", position=at(21, 18))["range"],
           {"start": at(16, 13), "end": at(16, 16)})
    expect("references", len(ask("references", position=at(16, 14),
                                 context={"includeDeclaration": True})), 2)
    expect("highlights", len(ask("documentHighlight", position=at(16, 14))), 2)
    expect("rename", ask("prepareRename", position=at(16, 14))["placeholder"], "red")
    edits = ask("rename", position=at(16, 14), newName="ruby")["changes"][URI]
    expect("renamed", "Material ruby {" in applied(GOOD, edits), True)
    refused = client.ask("textDocument/rename", **DOCUMENT, position=at(16, 14), newName="Sphere")
    expect("refused", refused["error"]["code"], -32803)
    everything = {"start": at(0, 0), "end": at(99, 0)}
    expect("hints", [h["label"] for h in ask("inlayHint", range=everything)], ["red"])
    expect("links", ask("documentLink"), [])
    expect("status", client.stop(), 0)


def test_files(program):
    """A texture that comes and goes; a mesh whose text is open; a file that is not open."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "a b.scene")
        uri = "file://" + path.replace(" ", "%20")
        text = GOOD.replace("Sphere {\n        center 0 0 0\n        radius 1\n    }",
                            "TriangleMesh {\n        obj_file m.obj\n    }")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        client = Client(program)
        client.start()
        symbols = client.ask("textDocument/documentSymbol", textDocument={"uri": uri})["result"]
        expect("read from the disk", len(symbols), 5)
        client.open(uri, text)
        expect("missing", [f["code"].startswith("asset") for f in client.findings(uri)], [True])
        with open(os.path.join(folder, "m.obj"), "w", encoding="utf-8") as file:
            file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        client.notify("workspace/didChangeWatchedFiles", changes=[])
        expect("there", client.findings(uri), [])
        links = client.ask("textDocument/documentLink", textDocument={"uri": uri})["result"]
        expect("link", links[0]["target"], "file://" + folder + "/m.obj")
        with open(os.path.join(folder, "m.obj"), "w", encoding="utf-8") as file:
            file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")
        client.notify("textDocument/didSave", textDocument={"uri": uri})
        mesh = "file://" + folder + "/m.obj"
        found = client.findings(mesh)
        expect("of the mesh", [f["range"]["start"]["line"] for f in found], [3])
        client.notify("textDocument/didClose", textDocument={"uri": uri})
        expect("nobody's", client.findings(mesh), [])
        expect("status", client.stop(), 0)


def main():
    program = sys.argv[1]
    tests = {name[5:]: test for name, test in globals().items() if name.startswith("test_")}
    failed = 0
    for name in sys.argv[2:] or tests:
        try:
            tests[name](program)
            print(f"ok       {name}")
        except (AssertionError, EOFError, KeyError, IndexError, TypeError) as problem:
            failed += 1
            print(f"FAILED   {name}: {type(problem).__name__} {problem}")
    print(f"test cases: {len(sys.argv[2:] or tests)} | {failed} failed")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
