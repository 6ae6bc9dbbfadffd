"""Writes the weights that the engine reads (engine/ribs/learned/network.h), and what its test compares with.

export.py NET.pt… assets/ribs-net.bin [--fixture tests/golden/ribs-net.fixture]
"""
import argparse
import struct
import zlib

import numpy as np
import torch

from model import CHANNELS, Net


def quantised(weight):
    """Bytes and a scale of every output; the module's weight becomes what the engine reads."""
    flat = weight.detach().flatten(1)
    scale = (flat.abs().amax(1) / 127).clamp_min(1e-8).to(torch.float32)
    whole = (flat / scale[:, None]).round().clamp(-127, 127)
    weight.data = (whole * scale[:, None]).view_as(weight)
    return whole.view_as(weight).to(torch.int8).numpy(), scale.numpy()


def weights_file(net):
    layers = net.layers()
    out = b"SLRN" + struct.pack("<II", 1, len(layers))
    body = b""
    for _, layer in layers:
        o, i, side, _ = layer.weight.shape
        out += struct.pack("<III", side, i, o)
        whole, scale = quantised(layer.weight)
        body += scale.astype("<f4").tobytes() + layer.bias.detach().numpy().astype("<f4").tobytes()
        body += np.ascontiguousarray(whole.transpose(2, 3, 1, 0)).tobytes()  # taps, inputs, outputs
    out += body
    return out + struct.pack("<I", zlib.crc32(out))


def read_weights(net, path):
    """A file that weights_file wrote, into a network of its sizes."""
    data = memoryview(open(path, "rb").read())
    at = 12 + 12 * len(net.layers())
    for _, layer in net.layers():
        o, i, side, _ = layer.weight.shape
        scale, bias = np.frombuffer(data, "<f4", 2 * o, at).copy().reshape(2, o)
        whole = np.frombuffer(data, np.int8, side * side * i * o, at + 8 * o).reshape(side, side, i, o)
        layer.weight.data = torch.from_numpy(whole.transpose(3, 2, 0, 1) * scale[:, None, None, None]).contiguous()
        layer.bias.data = torch.from_numpy(bias)
        at += 8 * o + whole.size


def fixture(net, rows=16, levels=32):
    """Seeded input, as bytes, and the scores of the exported weights in single precision."""
    x = np.random.default_rng(7).integers(-127, 128, (2, rows, levels, CHANNELS), np.int8)
    planes = torch.from_numpy(x.astype(np.float32) / 127).permute(0, 3, 1, 2)
    with torch.no_grad():
        y = net.float()(planes).numpy().astype("<f4")
    return struct.pack("<II", rows, levels) + x.tobytes() + y.tobytes()


def main():
    p = argparse.ArgumentParser()
    p.add_argument("nets", nargs="+", help="of several the mean; random: weights that nothing was trained on")
    p.add_argument("weights")
    p.add_argument("--fixture")
    a = p.parse_args()
    net = Net()
    if a.nets != ["random"]:
        states = [torch.load(path) for path in a.nets]
        net.load_state_dict({key: sum(state[key] for state in states) / len(states) for key in states[0]})
    open(a.weights, "wb").write(weights_file(net))
    if a.fixture:
        open(a.fixture, "wb").write(fixture(net))
    print(sum(q.numel() for q in net.parameters()), "weights")


if __name__ == "__main__":
    main()
