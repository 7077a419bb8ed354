# SPDX-License-Identifier: Apache-2.0
"""The engines for SciPy."""

import copy
import inspect
import pickle

import numpy as np
import pytest
from scipy import integrate, stats

import wellstrat
from wellstrat import qmc

ENGINES = (qmc.OwenSobol, qmc.PMJ, qmc.Blue)


@pytest.fixture(params=ENGINES, ids=lambda engine: engine.__name__)
def engine(request):
    return request.param


@pytest.mark.parametrize("d", (0, 1, 2, 3, 4, 5, 33, 40))
def test_samples(engine, d):
    sample = engine(d, seed=1).random(64)
    assert sample.shape == (64, d) and sample.dtype == np.float64
    assert ((sample > 0) & (sample < 1)).all()
    for column in sample.T:  # each is stratified
        assert sorted(np.floor(column * 64)) == list(range(64))
    assert len(np.unique(sample, axis=1).T) == d  # and none is another


def test_they_are_the_samples_of_the_library():
    for engine, generator, bits in ((qmc.OwenSobol, "long", 32), (qmc.PMJ, "pmj", 24)):
        pattern = int(np.random.default_rng(8).integers(2**32))
        expected = wellstrat.samples(pattern, 100, 0, 3, generator, dtype=np.float64)
        assert np.array_equal(engine(3, seed=8).random(100), expected + 0.5 ** (bits + 1))


def test_pairs_are_slots_that_are_stratified_together(engine):
    sample = engine(4, seed=3).random(256)
    for first in (0, 2):
        x, y = sample[:, first], sample[:, first + 1]
        for columns in (1, 2, 16, 64, 256):
            cells = np.floor(x * columns) * (256 // columns) + np.floor(y * (256 // columns))
            assert sorted(cells) == list(range(256))

    def error(samples):
        return samples.prod(axis=1).mean() - 1 / 16

    def padded(seed):
        return np.hstack([engine(2, seed=seed).random(256), engine(2, seed=seed + 1000).random(256)])

    joint = np.sqrt(np.mean([error(engine(4, seed=s).random(256)) ** 2 for s in range(60)]))
    apart = np.sqrt(np.mean([error(padded(s)) ** 2 for s in range(60)]))
    assert joint < 0.8 * apart


def test_it_goes_on_where_it_was(engine):
    whole = engine(5, seed=2).random(1000)
    parts = engine(5, seed=2)
    assert np.array_equal(np.vstack([parts.random(n) for n in (1, 0, 99, 400, 500)]), whole)
    assert parts.num_generated == 1000
    assert np.array_equal(parts.reset().random(1000), whole)
    assert np.array_equal(engine(5, seed=2).fast_forward(700).random(300), whole[700:])
    assert np.array_equal(engine(5, seed=2).random(), whole[:1])


def test_seeds(engine):
    def first(**options):
        return engine(2, **options).random(4)

    assert np.array_equal(first(seed=5), first(seed=5))
    assert np.array_equal(first(seed=5), first(rng=5))
    assert np.array_equal(first(seed=5), first(seed=np.int64(5)))
    assert np.array_equal(first(seed=np.random.default_rng(5)), first(seed=5))
    assert not np.array_equal(first(seed=5), first(seed=6))
    assert not np.array_equal(first(), first())
    assert first(seed=np.random.RandomState(5)).shape == (4, 2)
    generator = np.random.default_rng(5)
    assert not np.array_equal(first(seed=generator), first(seed=generator))


def test_pickling(engine):
    original = engine(7, seed=4)
    original.random(10)
    for again in (pickle.loads(pickle.dumps(original)), copy.deepcopy(original)):
        assert np.array_equal(again.random(5), engine(7, seed=4).random(15)[10:])
        assert np.array_equal(again.reset().random(3), engine(7, seed=4).random(3))


def test_integers(engine):
    numbers = engine(2, seed=1).integers([0, -8], u_bounds=[16, 8], n=16)
    assert sorted(numbers[:, 0]) == list(range(16)) and sorted(numbers[:, 1]) == list(range(-8, 8))
    inclusive = engine(1, seed=1).integers(1, u_bounds=6, n=600, endpoint=True)
    assert set(inclusive.ravel()) == set(range(1, 7))


def test_normal_distributions(engine):
    covariance = np.array([[2.0, 0.5], [0.5, 1.0]])
    for inverse in (True, False):
        normal = stats.qmc.MultivariateNormalQMC(
            [1, -1], covariance, engine=engine(2, seed=3), inv_transform=inverse)
        sample = normal.random(4096)
        assert np.isfinite(sample).all()
        assert np.allclose(sample.mean(axis=0), [1, -1], atol=0.01)
        assert np.allclose(np.cov(sample.T), covariance, atol=0.03)


def test_quadrature(engine):
    public = getattr(integrate, "qmc_quad", None)
    axis = 0 if public else -1  # of coordinates: SciPy 1.10 has it as a private function

    def integrand(x):
        return np.exp(-(x**2).sum(axis=axis))

    quadrature = public or integrate._quadrature._qmc_quad
    result = quadrature(integrand, [0, 0], [1, 1], n_points=1024, n_estimates=8,
                        qrng=engine(2, seed=6))
    assert abs(result.integral - 0.5577462853510337) < 1e-4
    assert 0 < result.standard_error < 1e-4


def test_optimization_is_scipys(engine):
    plain = engine(2, seed=1).random(16)
    moved = engine(2, seed=1, optimization="lloyd").random(16)
    assert moved.shape == plain.shape and not np.array_equal(moved, plain)


def test_neighboring_pixels_know_of_each_other():
    def error_of_tile(seed):
        means = [[qmc.Blue(2, pixel=(x, y), seed=seed).random(1).prod() for x in range(8)]
                 for y in range(8)]
        return np.mean(means) - 0.25

    def error_of_pixels(seed):
        return qmc.OwenSobol(2, seed=seed).random(1).prod() - 0.25

    together = np.sqrt(np.mean([error_of_tile(seed) ** 2 for seed in range(20)]))
    alone = np.sqrt(np.mean([error_of_pixels(seed) ** 2 for seed in range(1000)]))
    assert together < 0.5 * alone / 8  # of 64 independent pixels: alone / 8
    engine = qmc.Blue(2, pixel=(3, 4), seed=1)
    expected = wellstrat.draw(
        wellstrat.blue_contexts(8, 8, int(np.random.default_rng(1).integers(2**32)))[4, 3],
        generator="blue", dtype=np.float64)
    assert np.array_equal(engine.random(1)[0], expected + 0.5**33)


class NewerEngine(stats.qmc.QMCEngine):
    """As of SciPy 1.15: the argument is called `rng`, and what is drawn from is spawned from it."""

    def __init__(self, d, *, optimization=None, rng=None):
        sequence, = np.random.default_rng(rng).bit_generator._seed_seq.spawn(1)
        super().__init__(d, optimization=optimization, seed=np.random.default_rng(sequence))

    def _random(self, n=1, *, workers=1):
        raise NotImplementedError


def test_the_argument_of_newer_versions_of_scipy(monkeypatch):
    assert qmc._SEED == ("rng" if "rng" in inspect.signature(
        stats.qmc.QMCEngine.__init__).parameters else "seed")
    monkeypatch.setattr(stats.qmc, "QMCEngine", NewerEngine)
    source = inspect.getsource(qmc)
    newer = {"__name__": "wellstrat.newer_qmc", "__package__": "wellstrat"}
    exec(compile(source, qmc.__file__, "exec"), newer)
    assert newer["_SEED"] == "rng"
    assert issubclass(newer["OwenSobol"], NewerEngine)
    for name in ("seed", "rng"):
        sample = newer["OwenSobol"](2, **{name: 9}).random(8)
        assert np.array_equal(sample, qmc.OwenSobol(2, seed=9).random(8))
    for source in (np.random.default_rng, np.random.RandomState):
        sample = newer["PMJ"](2, seed=source(9)).random(8)
        assert np.array_equal(sample, qmc.PMJ(2, seed=source(9)).random(8))


@pytest.mark.parametrize("call, error, text", [
    (lambda engine: engine(-1), ValueError, "d must be a non-negative integer"),
    (lambda engine: engine(1.5), ValueError, "d must be a non-negative integer"),
    (lambda engine: engine(10**9), ValueError, "d must be from 0 to 65536, not 1000000000"),
    (lambda engine: engine(2, seed="x"), TypeError, "seed must be None, an integer or a Generator"),
    (lambda engine: engine(2, seed=-1), ValueError, "non-negative"),
    (lambda engine: engine(2, seed=1, rng=1), TypeError, "two names of one argument"),
    (lambda engine: engine(2).random(-1), ValueError, "n must be from 0 to 4294967296, not -1"),
    (lambda engine: engine(2).random(2**40), ValueError, "n must be from 0 to 4294967296"),
    (lambda engine: engine(2).random(1.5), TypeError, "n must be an integer"),
    (lambda engine: engine(2).fast_forward(2**32).random(1), ValueError, "n must be from 0 to 0, not 1"),
    (lambda engine: engine(2).fast_forward(-1), ValueError, "n must be from 0"),
])
def test_refused(engine, call, error, text):
    with pytest.raises(error, match=text):
        call(engine)


def test_pixels_are_refused():
    with pytest.raises(TypeError, match="pixel must be a pair of integers"):
        qmc.Blue(2, pixel=3)
