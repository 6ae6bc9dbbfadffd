"""Trains the network on strips (spineloft_strips). See README.md.

train.py STRIPS_GLOB --val VAL_GLOB --out NET.pt [--steps 12000] [--seed 1]
"""
import argparse
import copy
import glob
import math
import time

import numpy as np
import torch
import torch.nn.functional as F

from model import CHANNELS, Net

COLOUR, FAN, REACHED = (0, 1, 2), 15, 14


def load(patterns):
    """Memory maps of all shards: planes (n, 2, rows, levels, channels) int8, exits (n, 2, rows)."""
    shards = []
    for path in sorted(p for pattern in patterns for p in glob.glob(pattern)):
        base = path[: -len(".planes")]
        names = open(base + ".txt").read().splitlines()
        exits = np.fromfile(base + ".exits", np.float32)
        if not names:
            continue
        exits = exits.reshape(len(names), 2, -1)
        planes = np.memmap(path, np.int8, "r").reshape(*exits.shape, -1, CHANNELS)
        shards.append((planes, exits, names))
    return shards


def items(shards):
    """By shape: [(shard, strip)]."""
    groups = {}
    for s, shard in enumerate(shards):
        groups.setdefault(shard[0].shape[1:], []).extend((s, i) for i in range(len(shard[1])))
    return list(groups.values())


def fetch(shards, picks):
    x = np.stack([shards[s][0][i] for s, i in picks])
    t = np.stack([shards[s][1][i] for s, i in picks])
    return torch.from_numpy(x), torch.from_numpy(t)


def augment(x, t, rng):
    """In the strip: rows reversed, sides swapped, lightness inverted, hue turned, chroma scaled, noise, holes."""
    n = len(x)
    for i in range(n):
        if rng.random() < 0.5:
            x[i], t[i] = x[i].flip(1), t[i].flip(1)
        if rng.random() < 0.5:
            x[i], t[i] = x[i].flip(0), t[i].flip(0)
    light = torch.from_numpy(np.where(rng.random(n) < 0.3, -1.0, 1.0) * rng.uniform(0.8, 1.2, n)).float()
    angle = rng.uniform(0, 2 * math.pi, n) * (rng.random(n) < 0.7)
    chroma = rng.uniform(0.3, 1.3, n)
    view = (n, 1, 1, 1)
    c = torch.from_numpy(chroma * np.cos(angle)).float().view(view)
    s = torch.from_numpy(chroma * np.sin(angle)).float().view(view)
    a, b = x[..., 1].clone(), x[..., 2].clone()
    x[..., 0] *= light.view(view)
    x[..., 1] = c * a - s * b
    x[..., 2] = s * a + c * b
    noise = torch.from_numpy(rng.uniform(0, 0.03, n) * (rng.random(n) < 0.5)).float().view(n, 1, 1, 1, 1)
    reached = x[..., REACHED:REACHED + 1].clone()
    x[..., :12] += noise * torch.randn(x[..., :12].shape)
    for i in range(n):
        if rng.random() < 0.15:
            side, rows, levels = rng.integers(2), rng.integers(2, 14), rng.integers(4, 30)
            r, k = rng.integers(x.shape[2] - rows), rng.integers(x.shape[3] - levels)
            x[i, side, r:r + rows, k:k + levels] = 0
    x *= (reached > 0)
    return x.clamp_(-1.2, 1.2), t


def prepared(x):
    """Strips as the network takes them."""
    return x.flatten(0, 1).permute(0, 3, 1, 2)


def log_likelihood(net, x):
    """(strokes, 2, rows, levels); label 0 has none."""
    with torch.autocast("cpu", torch.bfloat16):
        y = net(prepared(x))
    y = y.float()
    y[..., 0] = -30
    return F.log_softmax(y, -1).unflatten(0, (-1, 2))


def losses(logp, t):
    labels = torch.arange(logp.shape[-1]).float()
    known = t >= 0
    k = torch.where(known, t, torch.zeros_like(t)).unsqueeze(-1)
    target = torch.exp(-0.5 * ((labels - k) / 0.8) ** 2)
    target = target / target.sum(-1, keepdim=True).clamp_min(1e-6)
    ce = -(target * logp).sum(-1)
    far = (logp.exp() * ((labels - k).abs() / 12).clamp(max=1)).sum(-1)
    return ce[known], far[known]


def learning_rate(share, peak=3e-3):
    return peak * (min(1, share / 0.03) * 0.5 * (1 + math.cos(math.pi * share)) + 0.004)


@torch.no_grad()
def validate(net, shards, most=600):
    """Cross entropy, expected distance, and the share of rows whose best label is within 3; of every shape."""
    net.eval()
    found = []
    for picks in items(shards):
        picks = picks[:: max(1, len(picks) // most)]
        sums = np.zeros(4)
        for i in range(0, len(picks), 16):
            x, t = fetch(shards, picks[i:i + 16])
            logp = log_likelihood(net, x.float() / 127)
            ce, far = losses(logp, t)
            close = ((logp.argmax(-1) - t).abs() <= 3)[t >= 0]
            sums += ce.sum().item(), far.sum().item(), close.sum().item(), len(ce)
        found.append(" ".join(f"{v:.4f}" for v in sums[:3] / sums[3]))
    net.train()
    return ", ".join(found)


def main():
    p = argparse.ArgumentParser()
    p.add_argument("strips", nargs="+")
    p.add_argument("--val", nargs="+", required=True)
    p.add_argument("--out", required=True)
    p.add_argument("--steps", type=int, default=12000)
    p.add_argument("--batch", type=int, default=16)
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--start", help="weights to begin with")
    p.add_argument("--peak", type=float, default=3e-3)
    p.add_argument("--threads", type=int, default=1)
    a = p.parse_args()
    torch.set_num_threads(a.threads)
    torch.manual_seed(a.seed)
    rng = np.random.default_rng(a.seed)
    net = Net().to(memory_format=torch.channels_last)
    if a.start:
        net.load_state_dict(torch.load(a.start))
    average = copy.deepcopy(net)
    opt = torch.optim.AdamW(net.parameters(), lr=a.peak, weight_decay=1e-4)
    val = load(a.val)
    began = time.time()
    shards = load(a.strips)
    groups = items(shards)
    orders = [[] for _ in groups]
    often = np.sqrt([len(group) for group in groups])
    print([len(group) for group in groups], "strips", flush=True)
    print(sum(q.numel() for q in net.parameters()), "weights", flush=True)
    mean = [0.0, 0.0]
    for step in range(1, a.steps + 1):
        which = rng.choice(len(groups), p=often / often.sum())
        if len(orders[which]) < a.batch:
            orders[which] = list(rng.permutation(len(groups[which])))
        batch = [groups[which][orders[which].pop()] for _ in range(a.batch)]
        for group in opt.param_groups:
            group["lr"] = learning_rate(step / a.steps, a.peak)
        x, t = fetch(shards, batch)
        x, t = augment(x.float() / 127, t, rng)
        ce, far = losses(log_likelihood(net, x), t)
        loss = ce.mean() + 0.7 * far.mean()
        opt.zero_grad(set_to_none=True)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(net.parameters(), 1.0)
        opt.step()
        keep = min(0.999, 1 - 1 / (1 + step / 10))
        with torch.no_grad():
            for q, w in zip(average.parameters(), net.parameters()):
                q.lerp_(w, 1 - keep)
        mean[0] += 0.02 * (ce.mean().item() - mean[0])
        mean[1] += 0.02 * (far.mean().item() - mean[1])
        if step % 200 == 0:
            minutes = (time.time() - began) / 60
            print(f"{step} in {minutes:.1f} min ce {mean[0]:.3f} far {mean[1]:.4f}", flush=True)
        if step % 1000 == 0 or step == a.steps:
            torch.save(average.state_dict(), a.out)
            print(step, "validation", validate(average, val), flush=True)


if __name__ == "__main__":
    main()
