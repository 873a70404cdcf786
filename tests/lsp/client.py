# SPDX-License-Identifier: MIT
"""A client of `cobble lsp`, of just what its tests need."""

import json
import subprocess


class Client:
    """Starts the server; every message that arrives is kept in `messages`."""

    def __init__(self, program, *options):
        self.process = subprocess.Popen([program, "lsp", *options], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE)
        self.messages = []
        self.next_id = 0

    def send_bytes(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        body = json.dumps(message).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n" % len(body) + body)

    def notify(self, method, **params):
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def ask(self, method, **params):
        """The answer, result or error; what arrives before it is kept."""
        self.next_id += 1
        number = self.next_id
        self.send({"jsonrpc": "2.0", "id": number, "method": method, "params": params})
        return self.wait(lambda message: message.get("id") == number)

    def read(self):
        """The next message, or None at the end."""
        length = None
        while True:
            line = self.process.stdout.readline()
            if not line:
                return None
            if line == b"\r\n":
                break
            name, _, value = line.partition(b":")
            if name.lower() == b"content-length":
                length = int(value)
        message = json.loads(self.process.stdout.read(length))
        self.messages.append(message)
        return message

    def wait(self, wanted):
        """The next message of which `wanted` is true."""
        while True:
            message = self.read()
            if message is None:
                raise EOFError("the server has gone")
            if wanted(message):
                return message

    def start(self, encodings=("utf-16",), **capabilities):
        capabilities = {"general": {"positionEncodings": list(encodings)}, **capabilities}
        answer = self.ask("initialize", processId=None, rootUri=None, capabilities=capabilities)
        self.notify("initialized")
        return answer["result"]

    def open(self, uri, text, version=1):
        self.notify("textDocument/didOpen", textDocument={
            "uri": uri, "languageId": "cobble", "version": version, "text": text})

    def change(self, uri, version, *changes):
        self.notify("textDocument/didChange", textDocument={"uri": uri, "version": version},
                    contentChanges=list(changes))

    def findings(self, uri, version=None):
        """The next ones that are published of the document."""
        message = self.wait(lambda m: m.get("method") == "textDocument/publishDiagnostics" and
                            m["params"]["uri"] == uri and
                            (version is None or m["params"].get("version") == version))
        return message["params"]["diagnostics"]

    def stop(self):
        """The exit status after a proper end."""
        self.ask("shutdown")
        self.notify("exit")
        self.process.stdin.close()
        return self.process.wait()
