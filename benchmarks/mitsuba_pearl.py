"""A pearl's reflection by Mitsuba 3 (llvm_ad_rgb), to compare with ours; run by `reflection.py`.

    python mitsuba_pearl.py FOLDER SAMPLES SEED

in an environment that has Mitsuba, on FOLDER/job.json, table.npy and panorama.npy. Writes
FOLDER/mitsuba.npy, linear RGB, and FOLDER/answer.json with the processor seconds of the render,
after another of few samples, which compiles.
"""

from __future__ import annotations

import json
import math
import sys
import time
from pathlib import Path
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")


class Nacre(mi.BSDF):
    """GGX facets that reflect by a table over the cosine at the facet, and absorb the rest."""

    def __init__(self, properties: mi.Properties) -> None:
        mi.BSDF.__init__(self, properties)
        self.alpha = properties["alpha"]
        table = np.load(properties["table"]).astype(np.float32)  # [cosine, rgb], from 0 to 1
        self.rows = len(table)
        self.table = mi.Float(table.ravel())
        flags = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide
        self.m_components = [flags]
        self.m_flags = flags

    def facets(self) -> mi.MicrofacetDistribution:
        """Of those that a direction sees."""
        return mi.MicrofacetDistribution(mi.MicrofacetType.GGX, self.alpha, True)

    def reflectance(self, cosine: mi.Float) -> mi.Color3f:
        """Straight lines between the table's rows."""
        place = dr.clip(cosine, 0.0, 1.0) * (self.rows - 1)
        low = dr.minimum(mi.UInt32(place), self.rows - 2)
        share = place - mi.Float(low)
        below = dr.gather(mi.Color3f, self.table, low)
        above = dr.gather(mi.Color3f, self.table, low + 1)
        return dr.lerp(below, above, share)

    def sample(
        self, context: Any, si: Any, sample1: Any, sample2: Any, active: Any = True
    ) -> tuple[Any, Any]:
        """A direction of light, and radiance over its density."""
        facets = self.facets()
        normal, density = facets.sample(si.wi, sample2)
        cos_half = dr.dot(si.wi, normal)
        found = mi.BSDFSample3f()
        found.wo = mi.reflect(si.wi, normal)
        found.eta = 1.0
        found.sampled_component = 0
        found.sampled_type = +mi.BSDFFlags.GlossyReflection
        found.pdf = density / (4.0 * cos_half)
        both = (mi.Frame3f.cos_theta(si.wi) > 0) & (mi.Frame3f.cos_theta(found.wo) > 0)
        active &= both & (found.pdf > 0)
        weight = facets.smith_g1(found.wo, normal) * self.reflectance(cos_half)
        return found, dr.select(active, weight, 0.0)

    def eval(self, context: Any, si: Any, wo: Any, active: Any = True) -> Any:
        """Radiance, times the cosine of incidence."""
        return self.eval_pdf(context, si, wo, active)[0]

    def pdf(self, context: Any, si: Any, wo: Any, active: Any = True) -> Any:
        """Density by solid angle."""
        return self.eval_pdf(context, si, wo, active)[1]

    def eval_pdf(self, context: Any, si: Any, wo: Any, active: Any = True) -> tuple[Any, Any]:
        """Both."""
        cos_view, cos_light = mi.Frame3f.cos_theta(si.wi), mi.Frame3f.cos_theta(wo)
        active &= (cos_view > 0) & (cos_light > 0)
        half = dr.normalize(si.wi + wo)
        facets = self.facets()
        # Of the facets seen; the radiance is that times the masking of the other side.
        density = facets.eval(half) * facets.smith_g1(si.wi, half) / (4.0 * cos_view)
        value = density * facets.smith_g1(wo, half) * self.reflectance(dr.dot(si.wi, half))
        return dr.select(active, value, 0.0), dr.select(active, density, 0.0)

    def to_string(self) -> str:
        """For Mitsuba's messages."""
        return f"Nacre[alpha={self.alpha}]"


mi.register_bsdf("nacre", Nacre)


def scene(folder: Path, job: dict[str, Any]) -> mi.Scene:
    """The ball, the camera and the world; y is up, z towards the viewer, as in our scenes."""
    elevation, distance_mm = math.radians(job["elevation_deg"]), job["distance_mm"]
    eye = [0.0, distance_mm * math.sin(elevation), distance_mm * math.cos(elevation)]
    # Mitsuba's panoramas begin where the middle of ours is.
    world = np.load(folder / "panorama.npy")
    world = np.ascontiguousarray(np.roll(world, world.shape[1] // 2, axis=1))
    return mi.load_dict(
        {
            "type": "scene",
            # A convex body mirrors nothing twice: that of one bounce does it, faster than "path".
            "integrator": {"type": "direct"},
            "sensor": {
                "type": "perspective",
                "fov_axis": "x",
                "fov": 2 * math.degrees(math.atan(0.5 * job["field_mm"] / distance_mm)),
                "near_clip": 0.1 * distance_mm,
                "far_clip": 10 * distance_mm,
                "to_world": mi.ScalarTransform4f().look_at(eye, [0, 0, 0], [0, 1, 0]),
                "film": {
                    "type": "hdrfilm",
                    "width": job["size"],
                    "height": job["size"],
                    "rfilter": {"type": "box"},
                },
                "sampler": {"type": job["sampler"]},
            },
            "world": {"type": "envmap", "bitmap": mi.Bitmap(world)},
            "pearl": {
                "type": "sphere",
                "radius": 0.5 * job["diameter_mm"],
                "surface": {
                    "type": "nacre",
                    "alpha": job["alpha"],
                    "table": str(folder / "table.npy"),
                },
            },
        }
    )


def main() -> None:
    folder, samples, seed = Path(sys.argv[1]), *map(int, sys.argv[2:4])
    world = scene(folder, json.loads((folder / "job.json").read_text()))
    np.array(mi.render(world, spp=4, seed=seed + 1))
    begin_s = time.process_time()
    picture = np.array(mi.render(world, spp=samples, seed=seed))[..., :3]
    took_s = time.process_time() - begin_s
    np.save(folder / "mitsuba.npy", picture.astype(np.float32))
    answer = {"s": took_s, "version": mi.__version__}
    (folder / "answer.json").write_text(json.dumps(answer))


if __name__ == "__main__":
    main()
