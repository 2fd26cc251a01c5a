#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Simulates a farm of slipbench-mpi, event by event: ranks that take batches of chunks from one counter.

usage: farm_model.py [--ranks N] [--samples N] [--sample SECONDS] [--longest R] [--question SECONDS] [--answer SECONDS] ...

A rank asks the counter for a batch (the question travels there and back), the counter answers one after the other, and
the rank runs the chunks of the batch. Batches shrink as batch_size() of driver/farm/run_farm.cpp says. Samples last from
the shortest to `--longest` times as long, ascending, which is the worst order. Told are the efficiency (time of all samples
over time and ranks), how busy the counter is, and what journals and their joining take. docs/guide/scaling.md tells what
the numbers of the defaults rest on.
"""
import argparse
import dataclasses
import heapq

BATCHES_A_RANK = 8


@dataclasses.dataclass
class Farm:
    ranks: int = 64_000
    samples: int = 1_000_000_000
    sample: float = 0.1  # [s] on the mean
    longest: float = 1.0  # the longest sample, by the shortest
    chunk: int = 128  # most samples of a chunk
    chunk_time: float = 0.016  # [s] of run time that a chunk of long samples is cut to
    question: float = 20e-6  # [s] there and back
    answer: float = 0.2e-6  # [s] of the counter for one
    start: float = 5.0  # [s] of the job, until the ranks run
    point: float = 4.4e-9  # [s] for a point of the sampler, which every rank passes over
    numbers: int = 8  # collected
    parameters: int = 4
    join: float = 1.2e-6  # [s] a sample
    disk: float = 1e9  # [bytes/s] of the folder


def batch_size(left, ranks):
    return max(1, left // (BATCHES_A_RANK * ranks))


def chunk_of(farm):
    return max(1, min(farm.chunk, int(farm.chunk_time / farm.sample)))


def simulate(farm):
    """Returns the figures by name."""
    size = chunk_of(farm)
    chunks = -(-farm.samples // size)
    shortest = 2.0 * farm.sample / (1.0 + farm.longest)

    def run_time(first, end):
        """Of chunks first .. end - 1: the integral over lengths that ascend linearly."""
        a, b = (shortest * (1.0 + (farm.longest - 1.0) * k / chunks) for k in (first, end))
        return (end - first) * size * 0.5 * (a + b) * farm.samples / (chunks * size)

    half = 0.5 * farm.question
    arrivals = [(half, 0, rank) for rank in range(farm.ranks)]  # when a question is at the counter, and what it knew
    heapq.heapify(arrivals)
    free = busy = finish = work = 0.0
    counter = questions = 0
    while arrivals:
        at, known, rank = heapq.heappop(arrivals)
        free = max(free, at) + farm.answer
        busy += farm.answer
        questions += 1
        batch = batch_size(chunks - known, farm.ranks)
        first, counter = counter, counter + batch
        if first >= chunks:
            finish = max(finish, free + half)
            continue
        took = run_time(first, min(counter, chunks))
        work += took
        done = free + half + took
        finish = max(finish, done)
        heapq.heappush(arrivals, (done + half, first, rank))
    passed = farm.point * farm.samples
    record = 32 / size + 8 * farm.numbers
    row = 17.0 * (farm.numbers + farm.parameters) + 10.0  # bytes of text, with 16 digits and a comma each
    whole = farm.start + passed + finish
    return {"chunks": chunks, "samples a chunk": size, "questions": questions, "run [s]": finish, "with start and sampler [s]": whole,
            "efficiency of the run": work / (farm.ranks * finish), "efficiency with start and sampler": work / (farm.ranks * whole),
            "counter busy": busy / finish, "journals [GB]": farm.samples * record / 1e9, "result as text [GB]": farm.samples * row / 1e9,
            "joining [s]": farm.samples * max(farm.join, (record + row) / farm.disk)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    for field in dataclasses.fields(Farm):
        parser.add_argument("--" + field.name.replace("_", "-"), type=field.type, default=field.default, metavar="N",
                            help=f"default: {field.default}")
    for name, value in simulate(Farm(**vars(parser.parse_args()))).items():
        print(f"{name:36}{value:>16,.4g}" if isinstance(value, float) else f"{name:36}{value:>16,}")


if __name__ == "__main__":
    main()
