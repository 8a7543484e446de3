"""A bad line to a device: noisy.py RATE SEED COMMAND... runs the command and relays its standard input and output. Of the
bytes in either direction the given part is lost, changed or doubled."""

import os
import random
import subprocess
import sys
import threading


def spoilt(data, rate, dice):
    out = bytearray()
    for byte in data:
        if dice.random() >= rate:
            out.append(byte)
            continue
        kind = dice.randrange(3)
        if kind == 1:
            out.append(byte ^ (1 << dice.randrange(8)))
        elif kind == 2:
            out += bytes([byte, byte])
    return bytes(out)


def relay(source, target, rate, dice):
    while data := os.read(source, 4096):
        data = spoilt(data, rate, dice)
        while data:
            data = data[os.write(target, data):]
    os.close(target)


rate, seed = float(sys.argv[1]), int(sys.argv[2])
device = subprocess.Popen(sys.argv[3:], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
threading.Thread(target=relay, daemon=True,
                 args=(0, os.dup(device.stdin.fileno()), rate, random.Random(seed))).start()
device.stdin.close()
relay(device.stdout.fileno(), 1, rate, random.Random(-seed))
sys.exit(device.wait())
