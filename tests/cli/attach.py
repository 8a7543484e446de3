"""A device behind a serial port or a TCP port: attach.py pty|tcp FILE COMMAND... writes to FILE what --device takes, and
relays the first who connects to the standard input and output of the command."""

import os
import pty
import socket
import subprocess
import sys
import threading
import tty


def relay(source, target):
    try:
        while data := os.read(source, 4096):
            while data:
                data = data[os.write(target, data):]
    except OSError:  # the other side of a pseudoterminal is closed
        pass


def announce(path, name):
    with open(path + ".part", "w", encoding="ascii") as file:
        file.write(name)
    os.rename(path + ".part", path)


kind, path, *command = sys.argv[1:]
if kind == "pty":
    line, port = pty.openpty()
    tty.setraw(port)
    announce(path, os.ttyname(port))
else:
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(60)
        announce(path, f"tcp:127.0.0.1:{server.getsockname()[1]}")
        line = server.accept()[0].detach()
device = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
threading.Thread(target=relay, daemon=True, args=(device.stdout.fileno(), line)).start()
relay(line, device.stdin.fileno())
device.kill()
