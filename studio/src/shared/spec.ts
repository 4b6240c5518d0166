/* Made by ./just types, never by hand. SHA-256 of its schema:
 * 64b8e729558649ecb14d000e34bc21bf3c716999a595048cf2349871c0bc6fe0
 */

/**
 * How many blemishes a pearl has, and how large they are (the transport model).
 */
export interface Blemishes {
  /**
   * Seed of their places. Allowed: 0 to 9223372036854775807. Left out: nacre.seed. Source: **(ours)**.
   */
  seed?: number;
  /**
   * Round hollows, all over the pearl. Allowed: 0 to 500. Source: trade, kinds of blemishes.
   */
  pits?: number;
  /**
   * Round rises. Allowed: 0 to 500. Source: trade, kinds of blemishes.
   */
  bumps?: number;
  /**
   * Narrow grooves, 6 times size_mm long and 0.15 wide. Allowed: 0 to 500. Source: trade, kinds of blemishes.
   */
  scratches?: number;
  /**
   * Long rises, 4 times size_mm long and 0.6 wide. Allowed: 0 to 500. Source: trade, kinds of blemishes.
   */
  wrinkles?: number;
  /**
   * Chalky spots without layers: they mirror nothing, and look darker where the pearl mirrors a window. Allowed: 0 to 500. Source: trade, kinds of blemishes.
   */
  chalky_spots?: number;
  /**
   * Mean diameter of what is round; what is long goes by it. Allowed: 0.02 to 5 mm. Source: **(ours)**; pin pricks are 0.1 mm.
   */
  size_mm?: number;
  /**
   * Mean depth or height. Allowed: 0 to 200 um. Source: **(ours)**.
   */
  depth_um?: number;
  /**
   * Share of the pearl that all of them cover together: sizes and depths are multiplied until they do, if there are any. Allowed: 0 to 0.25. Left out: what size_mm gives. Source: trade, words for the surface.
   */
  area?: number;
}
/**
 * What gives the pearl its body colour (the transport model).
 */
export interface Body {
  /**
   * The pigment of the nacre, by its absorption spectrum. Allowed: "none", "white", "cream", "pink", "gold", "black-lip", "dyed-blue". Source: data/pigments.csv; bands of gold and black-lip as published, the rest **(ours)**.
   */
  pigment?: "none" | "white" | "cream" | "pink" | "gold" | "black-lip" | "dyed-blue";
  /**
   * How much of the pigment there is: a factor on its absorption. Allowed: 0 to 10. Source: **(ours)**; 1 is a usual pearl of that colour.
   */
  pigment_strength?: number;
  /**
   * Thickness of the whole nacre; below about 0.3 mm the nucleus shows. Allowed: 0.01 to 15 mm. Left out: the thickness of the layers. Source: Pearl Science Laboratory, 0.4 mm and more is thick.
   */
  nacre_mm?: number;
  /**
   * Kubelka and Munk's scattering coefficient S of the nacre. Allowed: 0 to 1000 per mm. Source: **(ours)**: the nucleus begins to show below 0.3 mm.
   */
  scattering_per_mm?: number;
  /**
   * Reflectance of the nucleus for light that is inside, as the sRGB of a matt surface. Allowed: "#rrggbb", six hexadecimal digits of sRGB. Source: **(ours)**; a bead of shell, 0.97: its own surface not counted.
   */
  nucleus?: string;
  /**
   * How much darker the dark bands of the nucleus are than its colour; they show through thin nacre, and blink as the pearl turns. Allowed: 0 to 0.5. Source: trade, nuclei of freshwater shell; the share is **(ours)**.
   */
  nucleus_bands?: number;
  /**
   * From one dark band to the next. Allowed: 0.1 to 10 mm. Source: **(ours)**.
   */
  nucleus_band_mm?: number;
}
/**
 * Where the picture is taken from, how wide it is and how bright.
 */
export interface Camera {
  /**
   * Parallel rays, or rays that meet in the eye. Allowed: "orthographic" or "perspective". Source: **(ours)**; parallel rays make the view angle a function of the radius alone.
   */
  projection?: "orthographic" | "perspective";
  /**
   * Height of the camera above the horizon, seen from the pearl. Allowed: -80 to 89 degrees. Source: **(ours)**.
   */
  elevation_deg?: number;
  /**
   * Direction of the camera around the pearl, to the right positive. Allowed: -360 to 360 degrees. Source: **(ours)**.
   */
  azimuth_deg?: number;
  /**
   * Width of the view at the pearl's centre. Allowed: 0.1 to 10000 mm. Left out: 1.5 x the pearl's diameter, or as wide as the rows. Source: **(ours)**.
   */
  field_mm?: number;
  /**
   * Distance of the eye from the pearl's centre; parallel rays use it for glare alone. Allowed: 20 to 100000 mm. Source: **(ours)**.
   */
  distance_mm?: number;
  /**
   * Factor on the linear picture. Allowed: 0.001 to 1000. Source: **(ours)**.
   */
  exposure?: number;
  /**
   * Share of the light that lens and eye spread around bright things. Allowed: 0 to 0.5. Source: Vos 1984, Spencer et al. 1995; the share is **(ours)**.
   */
  glare?: number;
  /**
   * Radius, seen from distance_mm, within which half of the spread light stays. Allowed: 0.01 to 20 degrees. Source: **(ours)**; Vos 1984, Spencer et al. 1995 for how it falls off.
   */
  glare_deg?: number;
  /**
   * The light shown as white; auto is the lamps' own. Allowed: "auto", "A", "C", "D50", "D55", "D65", "D75", "E", "FL1" to "FL12", "LED-B1" to "LED-B5", "LED-BH1", "LED-RGB1", "LED-V1", "LED-V2", or a colour temperature from 1000K to 25000K. Source: CIE illuminants.
   */
  white?: string;
}
/**
 * The outer layers from place to place (the transport model): their thickness and relief.
 */
export interface Coat {
  /**
   * Seed of what differs from place to place. Allowed: 0 to 9223372036854775807. Left out: nacre.seed. Source: **(ours)**.
   */
  seed?: number;
  /**
   * Spread (standard deviation) of the layers' thickness over the pearl, as a share of it: patches of other colours. Allowed: 0 to 0.12. Source: **(ours)**; mabe pearls show patches some 5 % apart (docs/coat.md).
   */
  thickness_spread?: number;
  /**
   * Size of the patches: thickness is alike within it. Allowed: 0.3 to 30 mm. Source: **(ours)**.
   */
  patch_mm?: number;
  /**
   * Share of what differs that lies in bands about the axis of growth. Allowed: 0 to 1. Source: trade, circled pearls; the share is **(ours)**.
   */
  banding?: number;
  /**
   * Share of what differs beside the bands that changes with the angle it is seen at: patches that go over into others as the pearl turns. Allowed: 0 to 1. Source: paper 6 wishes for it, by chaos; the map is **(ours)** (docs/coat.md).
   */
  liveliness?: number;
  /**
   * Spread of the lean of a hammered surface: shallow dents that break the lamp's image. Allowed: 0 to 0.2 rad. Source: trade, hammered pearls; the number is **(ours)**.
   */
  hammering_rad?: number;
  /**
   * Size of the dents. Allowed: 0.3 to 10 mm. Source: **(ours)**.
   */
  dent_mm?: number;
  /**
   * Spread of the slopes of the grain, which tilts the surface where it is brighter or darker. Allowed: 0 to 0.2 rad. Left out: from the knob grain. Source: **(ours)**.
   */
  grain_relief_rad?: number;
  /**
   * Spacing of the growth front's terraces, which look like fingerprints; 0 for none. Allowed: 0 to 1000 um. Source: nacre's growth spirals; the spacing is **(ours)**.
   */
  terrace_um?: number;
  /**
   * Height of a terrace: a tablet's thickness. Allowed: 50 to 2000 nm. Source: paper 3.2.3, tablets of 300 to 500 nm.
   */
  terrace_step_nm?: number;
}
/**
 * The outer nacre as a film of many columns of tablets (the transport model).
 */
export interface Film {
  /**
   * Depth of the outer nacre whose layers interfere; what lies below only scatters. Allowed: 1 to 500 um. Left out: from the knob depth. Source: **(ours)**; the trade's reports speak of the outer 10 and 50 um.
   */
  outer_um?: number;
  /**
   * Columns of tablets whose reflectances are averaged. Allowed: 2 to 1024 columns. Source: **(ours)**.
   */
  columns?: number;
  /**
   * Spread (standard deviation) of each layer's thickness from column to column, added to what growth gives. Allowed: 0 to 200 nm. Left out: 0 where the layers are grown, 10 nm where they are listed. Source: Pearl Science Laboratory, 10 to 20 nm where teri is strong.
   */
  column_spread_nm?: number;
}
/**
 * The season's bell curves of layer thickness and of layers a day, and their noise.
 */
export interface Growth {
  /**
   * Thickness of the protein layer below each aragonite layer. Allowed: 0 to 200 nm. Source: paper 3.2.1, constant 20 nm.
   */
  protein_nm?: number;
  /**
   * What the aragonite layers are: an index n, [n, k] for n + ik, the pair along and across the layers, or a medium by name. Allowed: a number n above 0 to 10, [n, k] with k from 0 to 10, { n_o = ..., n_e = ... }, or "aragonite", "aragonite-isotropic-1.53", "chitin", "silk-fibroin", "protein-1.43". Source: paper 3.2.3, the value along the c-axis; about 1.683 is measured across it.
   */
  aragonite?:
    | (
        | number
        | [number, number]
        | ("aragonite" | "aragonite-isotropic-1.53" | "chitin" | "silk-fibroin" | "protein-1.43")
      )
    | Uniaxial;
  /**
   * What the protein layers are, likewise. Allowed: a number n above 0 to 10, [n, k] with k from 0 to 10, { n_o = ..., n_e = ... }, or "aragonite", "aragonite-isotropic-1.53", "chitin", "silk-fibroin", "protein-1.43". Source: paper 3.2.3; 1.43 to 1.56 in later work.
   */
  protein?:
    | (
        | number
        | [number, number]
        | ("aragonite" | "aragonite-isotropic-1.53" | "chitin" | "silk-fibroin" | "protein-1.43")
      )
    | Uniaxial;
  /**
   * The nacre preset whose values hold wherever this file gives none. Allowed: a name that `nacreous presets nacre` lists. Source: nacreous presets nacre.
   */
  preset?: string;
  /**
   * Seed of the growth's random numbers: same seed, same layers. Allowed: 0 to 9223372036854775807. Source: **(ours)**.
   */
  seed?: number;
  /**
   * Day on which the nucleus is put in. Allowed: "MM-DD" of every year but 02-29, or "YYYY-MM-DD". Source: **(ours)**.
   */
  seeding?: string;
  /**
   * Day of the harvest; as MM-DD, the first such day after seeding. Allowed: "MM-DD" of every year but 02-29, or "YYYY-MM-DD". Source: paper 3.2.1, December.
   */
  harvest?: string;
  /**
   * Day of each year on which both bell curves are highest. Allowed: "MM-DD" of every year but 02-29. Source: paper 3.2.1, summer; the day is **(ours)**.
   */
  peak?: string;
  /**
   * Standard deviation of both bell curves. Allowed: 1 to 365 days. Source: paper 3.2.1, bell curve; the standard deviation is **(ours)**.
   */
  season_days?: number;
  /**
   * Thickness of an aragonite layer far from the peak. Allowed: 50 to 5000 nm. Source: paper 3.2.1, 400 to 700 nm.
   */
  thickness_winter_nm?: number;
  /**
   * Thickness of an aragonite layer at the peak. Allowed: 50 to 5000 nm. Source: paper 3.2.1, 400 to 700 nm.
   */
  thickness_summer_nm?: number;
  /**
   * Layers a day far from the peak. Allowed: 0 to 20 layers a day. Source: paper 3.2.1, 1 to 3.
   */
  layers_winter?: number;
  /**
   * Layers a day at the peak. Allowed: 0 to 20 layers a day. Source: paper 3.2.1, 1 to 3.
   */
  layers_summer?: number;
  /**
   * Half width of the uniform noise on each layer's thickness. Allowed: 0 to 1000 nm. Source: paper 3.2.1, uniform random numbers; the width is **(ours)**.
   */
  thickness_noise_nm?: number;
  /**
   * Half width of the uniform noise on the layers of each day. Allowed: 0 to 5 layers a day. Source: paper 3.2.1, uniform random numbers; the width is **(ours)**.
   */
  layers_noise?: number;
}
/**
 * A uniaxial medium, its axis along the normal of the layers; lossless.
 */
export interface Uniaxial {
  /**
   * Index for the electric field along the layers. Allowed: above 0 to 10. Source: about 1.683 for aragonite.
   */
  n_o: number;
  /**
   * Index for the electric field along their normal. Allowed: above 0 to 10. Source: about 1.53 for aragonite.
   */
  n_e: number;
}
/**
 * The way of the light that has entered the pearl (the transport model).
 */
export interface Inside {
  /**
   * How far light spreads over the ball before it leaves: t of exp(-l (l + 1) t) on its spherical harmonics. 0 leaves each spot its own light; much of it lights all evenly. Allowed: 0 to 1000. Left out: from the knob depth. Source: **(ours)**; a heat kernel on the sphere.
   */
  spread?: number;
}
/**
 * How the interfering light is added up (the illuminant model, paper 3.2.4).
 */
export interface Interference {
  /**
   * Optical path difference up to which reflected waves interfere; 0 leaves no fringes. Allowed: 0 to 1000000 nm. Source: paper 3.2.4, 5 um.
   */
  coherence_nm?: number;
  /**
   * Share of the light going down at which the sum over start layers ends. Allowed: 0 to below 1. Source: paper 3.2.4, 0.05.
   */
  threshold?: number;
  /**
   * Share D of the light that each layer scatters, in T + R + D = 1. Allowed: 0 to 0.9. Left out: from the knob depth. Source: paper 4.1, equation 4.
   */
  diffuse_loss?: number;
  /**
   * Share of the interference component beside the diffuse one: 0 all diffuse, 1 none. Allowed: 0 to 1. Left out: from the knob depth. Source: paper 4.1, mixing ratio.
   */
  mixing?: number;
}
/**
 * A round lamp, given by its direction from the pearl or by its position.
 */
export interface Lamp {
  /**
   * Direction seen from the pearl, from the z axis to the right; with elevation_deg. Allowed: -360 to 360 degrees. Left out: position_mm is given instead. Source: **(ours)**; the paper's lamp stands at 45 degrees to the line of sight.
   */
  azimuth_deg?: number;
  /**
   * Height above the horizon, seen from the pearl; with azimuth_deg. Allowed: -90 to 90 degrees. Left out: position_mm is given instead. Source: **(ours)**.
   */
  elevation_deg?: number;
  /**
   * Position [x, y, z] from the pearl's centre: x right, y up, z towards the viewer. Allowed: three numbers from -100000 to 100000 mm. Left out: azimuth_deg and elevation_deg are given instead. Source: **(ours)**.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_mm?: [number, number, number];
  /**
   * Radius of the lamp as seen from the pearl. Allowed: 0.05 to 30 degrees. Source: **(ours)**.
   */
  angular_radius_deg?: number;
  /**
   * The lamp's light; a spectrum's path is relative to this file. Allowed: "A", "C", "D50", "D55", "D65", "D75", "E", "FL1" to "FL12", "LED-B1" to "LED-B5", "LED-BH1", "LED-RGB1", "LED-V1", "LED-V2", a colour temperature from 1000K to 25000K, or a path ending in .csv. Source: CIE illuminants.
   */
  spectrum?: string;
  /**
   * Irradiance at the pearl on a surface facing the lamp, relative. Allowed: 0 to 1000000. Source: **(ours)**.
   */
  intensity?: number;
}
/**
 * Nacre whose aragonite layers are given one by one.
 */
export interface Layers {
  /**
   * Thickness of the protein layer below each aragonite layer. Allowed: 0 to 200 nm. Source: paper 3.2.1, constant 20 nm.
   */
  protein_nm?: number;
  /**
   * What the aragonite layers are: an index n, [n, k] for n + ik, the pair along and across the layers, or a medium by name. Allowed: a number n above 0 to 10, [n, k] with k from 0 to 10, { n_o = ..., n_e = ... }, or "aragonite", "aragonite-isotropic-1.53", "chitin", "silk-fibroin", "protein-1.43". Source: paper 3.2.3, the value along the c-axis; about 1.683 is measured across it.
   */
  aragonite?:
    | (
        | number
        | [number, number]
        | ("aragonite" | "aragonite-isotropic-1.53" | "chitin" | "silk-fibroin" | "protein-1.43")
      )
    | Uniaxial;
  /**
   * What the protein layers are, likewise. Allowed: a number n above 0 to 10, [n, k] with k from 0 to 10, { n_o = ..., n_e = ... }, or "aragonite", "aragonite-isotropic-1.53", "chitin", "silk-fibroin", "protein-1.43". Source: paper 3.2.3; 1.43 to 1.56 in later work.
   */
  protein?:
    | (
        | number
        | [number, number]
        | ("aragonite" | "aragonite-isotropic-1.53" | "chitin" | "silk-fibroin" | "protein-1.43")
      )
    | Uniaxial;
  /**
   * Thickness of each aragonite layer in nm, the surface first. Instead of growth. Allowed: 1 to 5000 numbers, each above 0 to 100000 nm. Source: paper 3.1: 60 to 1000 layers of 300 to 800 nm.
   */
  thickness_nm: number[];
}
/**
 * A pearl file: everything that belongs to the pearl and not to its surroundings.
 */
export interface Pearl {
  /**
   * What the pearl is called. Allowed: one line of 1 to 120 characters. Source: free.
   */
  name?: string;
  /**
   * The model of the light: through the pearl and out again, or the paper's illuminant model. Allowed: "transport" or "illuminant". Source: Ozaki and others 2021; paper 3.1.
   */
  model?: "transport" | "illuminant";
  /**
   * Diameter of the whole pearl; of one that is not round, its width across the axis of growth. Allowed: 1 to 30 mm. Source: **(ours)**; paper 3.1, a nucleus of 3 to 6 mm.
   */
  diameter_mm?: number;
  /**
   * Body colour as sRGB: the colour of the diffuse component. Allowed: "#rrggbb", six hexadecimal digits of sRGB. Source: paper 4.1; the colour is **(ours)**. Only with model = "illuminant".
   */
  body_colour?: string;
  /**
   * Knob: strength of the interference colour against the body colour (fukami, maki). Allowed: 0 to 1. Source: paper 4.1.
   */
  depth?: number;
  /**
   * Knob: brightness and sharpness of what the surface mirrors (kagayaki, teri). Allowed: 0 to 1. Source: paper 4.2.
   */
  shininess?: number;
  /**
   * Knob: strength of the surface texture (kime). Allowed: 0 to 1. Source: paper 4.3.
   */
  grain?: number;
  /**
   * The layers: grown over a season, or listed in thickness_nm.
   */
  nacre?: Growth | Layers;
  /**
   * The outer layers, which interfere. Only with model = "transport".
   */
  film?: Film;
  /**
   * The scattering nacre and the nucleus. Only with model = "transport".
   */
  body?: Body;
  /**
   * The way of the light inside. Only with model = "transport".
   */
  inside?: Inside;
  /**
   * The sum of the interfering light. Only with model = "illuminant".
   */
  interference?: Interference;
  /**
   * The mirroring surface.
   */
  surface?: Surface;
  /**
   * The grain of the surface.
   */
  texture?: Texture;
  /**
   * What differs from place to place. Only with model = "transport".
   */
  coat?: Coat;
  /**
   * Pits, bumps and the like. Only with model = "transport".
   */
  blemishes?: Blemishes;
  /**
   * What makes the pearl other than round. Only with model = "transport".
   */
  shape?: Shape;
  /**
   * How the pearl is turned. Only with model = "transport".
   */
  pose?: Pose;
}
/**
 * How the surface mirrors lamps and surroundings (paper 4.2).
 */
export interface Surface {
  /**
   * Spread of the microscopic facets' slopes; wider blurs the lamp's image. Allowed: 0.005 to 0.6 rad. Left out: from the knob shininess. Source: paper 4.2, Torrance-Sparrow.
   */
  facet_spread_rad?: number;
  /**
   * Share of the mirrored surroundings that the surface leaves clear. Allowed: 0 to 1. Left out: from the knob shininess. Source: paper 4.2; as a weight **(ours)**. Only with model = "illuminant".
   */
  mirror_weight?: number;
  /**
   * Share of the light entering the surface that the layers mirror in the same direction; 0 leaves Fresnel's share alone, as in the paper. Allowed: 0 to 0.9. Source: exact reflectance of 100 bilayers: 0.09 isotropic, 0.24 uniaxial. Only with model = "illuminant".
   */
  layer_reflectance?: number;
  /**
   * Distance over which the mirrored image of a thing fades to 1/e of its contrast. Allowed: 0.1 to 1000000 mm. Source: paper 4.2, attenuation by distance; the length is **(ours)**. Only with model = "illuminant".
   */
  falloff_mm?: number;
  /**
   * How the microscopic facets lean: bell-shaped with grooves, or with GGX's long tails. Allowed: "torrance-sparrow" or "ggx". Source: paper 4.2, Torrance and Sparrow 1967; Walter and others 2007 (GGX). Only with model = "transport".
   */
  facets?: "torrance-sparrow" | "ggx";
  /**
   * Spread of the lean of the tablets below against the surface: what they mirror lies around the lamp's image, coloured; 0 leaves all in one image. Allowed: 0 to 0.3 rad. Source: 5 degrees to either side in mature nacre of Pinna, 7.5 in early nacre (Hovden and others 2015); of pearls nobody has measured it **(ours)**. Only with model = "transport".
   */
  waviness_rad?: number;
}
/**
 * The grain of the surface, from a photograph or a stand-in (paper 4.3).
 */
export interface Texture {
  /**
   * Photograph of a real pearl, its path relative to this file, or a procedural stand-in. Allowed: "procedural" or a path ending in .png, .jpg, .jpeg, .tif, .tiff. Source: paper 4.3; the stand-in is **(ours)**.
   */
  source?: string;
  /**
   * Size of the photograph's pixels on the pearl. Allowed: above 0 to 100 mm. Left out: unknown, and limits are in cycles a patch. Source: measured on the photograph.
   */
  mm_per_pixel?: number;
  /**
   * Side of the square patches whose spectrum is taken. Allowed: 8 to 4096 pixels. Source: paper 4.3, 64 x 64.
   */
  side_px?: number;
  /**
   * Lower limit of the band-pass filter. Allowed: above 0 to 1000 cycles per mm. Left out: the default band of the grain. Source: paper 4.3, band-pass filter.
   */
  low_per_mm?: number;
  /**
   * Upper limit of the band-pass filter. Allowed: above 0 to 1000 cycles per mm. Left out: the default band of the grain. Source: paper 4.3, band-pass filter.
   */
  high_per_mm?: number;
  /**
   * Seed of the texture's random phases. Allowed: 0 to 9223372036854775807. Left out: nacre.seed. Source: **(ours)**.
   */
  seed?: number;
  /**
   * Weight of the hue texture on the diffuse component. Allowed: 0 to 10. Left out: from the knob grain. Source: paper 4.4, weights found by trial.
   */
  hue_weight?: number;
  /**
   * Weight of the chroma texture on the diffuse component. Allowed: 0 to 10. Left out: from the knob grain. Source: paper 4.4, weights found by trial.
   */
  chroma_weight?: number;
  /**
   * Weight of the lightness texture on the mirrored component. Allowed: 0 to 10. Left out: from the knob grain. Source: paper 4.4, weights found by trial.
   */
  value_weight?: number;
}
/**
 * How far the surface is from the middle in every direction (the transport model).
 */
export interface Shape {
  /**
   * Seed of lumps and circles. Allowed: 0 to 9223372036854775807. Left out: nacre.seed. Source: **(ours)**.
   */
  seed?: number;
  /**
   * Length along the axis of growth over the width across it, which is diameter_mm: above 1 an oval, below 1 a button. Allowed: 0.5 to 2.5. Source: trade, sizes as width x length.
   */
  length?: number;
  /**
   * How much narrower one end is: a drop. Allowed: 0 to 3. Source: trade, drops; the form is **(ours)**.
   */
  taper?: number;
  /**
   * How much nearer to the middle one end is: a button's flat side. Allowed: 0 to 1.5. Source: trade, buttons; the form is **(ours)**.
   */
  flattening?: number;
  /**
   * Difference of the widths across the axis, as a share of their mean. Allowed: 0 to 0.3. Source: trade: round under 2 %, near-round 2 to 5 %.
   */
  out_of_round?: number;
  /**
   * Spread (standard deviation) of the lumps of a baroque pearl, as a share of the distance from its middle. Allowed: 0 to 0.2. Source: trade, baroque pearls; the form is **(ours)**.
   */
  lumps?: number;
  /**
   * Size of the lumps, from top to foot. Allowed: 0.5 to 20 mm. Left out: 0.6 x diameter_mm. Source: **(ours)**.
   */
  lump_mm?: number;
  /**
   * Grooves about the axis: a circled pearl. Allowed: 0 to 12. Source: trade, circled pearls.
   */
  circles?: number;
  /**
   * Mean depth of a groove, as a share of the distance from the middle. Allowed: 0 to 0.15. Source: trade, circled pearls; the number is **(ours)**.
   */
  circle_depth?: number;
  /**
   * Diameter of the hole along the axis, drilled through; 0 for none. Allowed: 0 to 3 mm. Source: trade: 0.6 to 1 mm for strands.
   */
  drill_mm?: number;
  /**
   * Width of the hole's worn edge. Allowed: 0 to 1 mm. Source: **(ours)**.
   */
  drill_wear_mm?: number;
}
/**
 * How the pearl is turned: grain, coat and blemishes turn with it (the transport model).
 */
export interface Pose {
  /**
   * Turn about the upright, as on a turntable. Allowed: -3600 to 3600 degrees. Source: **(ours)**.
   */
  turn_deg?: number;
  /**
   * Lean of the axis of growth from the upright towards azimuth 0. Allowed: -3600 to 3600 degrees. Left out: 0 for a round pearl; another lies at rest, its axis across the view. Source: **(ours)**.
   */
  tilt_deg?: number;
  /**
   * Turn about the axis of growth, before both. Allowed: -3600 to 3600 degrees. Source: **(ours)**.
   */
  spin_deg?: number;
}
/**
 * A row of pearls from left to right; the first row is the farthest from a camera at azimuth 0.
 */
export interface Row {
  /**
   * The pearls: presets, files relative to this one, "*" for the next of the pearls given to render, or "*0", "*1" and so on for one of them. Allowed: 1 to 400 pearl presets, paths ending in .toml, "*" or "*0" to "*999". Source: **(ours)**.
   */
  pearls?: string[];
  /**
   * How they lie: side by side on a line, or around a neck ("neck"), each touching the next, in the only row of its scene. Allowed: "line" or "neck". Source: trade: strands are shown around a bust; the ellipse is **(ours)**.
   */
  form?: "line" | "neck";
  /**
   * What the row is, for people who read the file. Allowed: one line of 1 to 120 characters. Left out: no label. Source: trade: masters above, goods below.
   */
  label?: string;
}
/**
 * A scene file: everything around the pearl.
 */
export interface Scene {
  /**
   * What the scene is called. Allowed: one line of 1 to 120 characters. Source: free.
   */
  name?: string;
  /**
   * CIE standard observer: of 1931 for 2 degrees, or of 1964 for 10. Allowed: "1931-2" or "1964-10". Source: CIE 015:2018.
   */
  observer?: "1931-2" | "1964-10";
  /**
   * Distance in a row from the middle of a pearl to that of the next. Allowed: 1 to 1000 mm. Left out: 1.1 x the largest pearl's diameter. Source: **(ours)**.
   */
  pitch_mm?: number;
  /**
   * Distance from the middle of a row to that of the next. Allowed: 1 to 1000 mm. Left out: 1.1 x the largest pearl's diameter. Source: **(ours)**.
   */
  row_gap_mm?: number;
  /**
   * The camera.
   */
  camera?: Camera;
  /**
   * The lamps, each headed [[lamps]]. Allowed: 0 to 256 tables, each headed [[lamps]]. Source: **(ours)**.
   */
  lamps?: Lamp[];
  /**
   * Rectangles of light, each headed [[windows]]. Allowed: 0 to 64 tables, each headed [[windows]]. Source: trade: north-window light, lit plates and panels.
   */
  windows?: Window[];
  /**
   * Rows of pearls, each headed [[rows]]; without them, the one pearl given. Allowed: 0 to 400 tables, each headed [[rows]]. Source: **(ours)**.
   */
  rows?: Row[];
  /**
   * The table below the pearl.
   */
  table?: Table;
  /**
   * The walls around; none when left out.
   */
  walls?: Walls;
  /**
   * What lies beyond.
   */
  sky?: Sky;
}
/**
 * A rectangle of even light, on one side: a window, a softbox, a lit plate.
 */
export interface Window {
  /**
   * Direction seen from the pearl, which the window faces; with elevation_deg. Allowed: -360 to 360 degrees. Left out: position_mm or below_mm is given instead. Source: **(ours)**.
   */
  azimuth_deg?: number;
  /**
   * Height above the horizon, seen from the pearl; with azimuth_deg. Allowed: -90 to 90 degrees. Left out: position_mm or below_mm is given instead. Source: **(ours)**.
   */
  elevation_deg?: number;
  /**
   * Distance of its middle from the pearl's centre; with azimuth_deg and elevation_deg. Allowed: 20 to 100000 mm. Left out: 1000 mm, or position_mm or below_mm is given instead. Source: **(ours)**.
   */
  distance_mm?: number;
  /**
   * Position [x, y, z] of its middle from the pearl's centre. Allowed: three numbers from -100000 to 100000 mm. Left out: azimuth_deg and elevation_deg, or below_mm, are given instead. Source: **(ours)**.
   *
   * @minItems 3
   * @maxItems 3
   */
  position_mm?: [number, number, number];
  /**
   * Direction [x, y, z] in which the window shines; with position_mm. Allowed: three numbers from -100000 to 100000, not all 0. Left out: towards the pearl. Source: **(ours)**.
   *
   * @minItems 3
   * @maxItems 3
   */
  facing?: [number, number, number];
  /**
   * The window lies flat and shines upward, this far below the pearls' lowest point. Allowed: 0.01 to 1000 mm. Left out: azimuth_deg and elevation_deg, or position_mm, are given instead. Source: **(ours)**; Aurora viewer, the pearl touches its light.
   */
  below_mm?: number;
  /**
   * Width: level, or along x for a window that lies flat. Allowed: 0.1 to 100000 mm. Source: **(ours)**.
   */
  width_mm?: number;
  /**
   * Height: at right angles to the width. Allowed: 0.1 to 100000 mm. Source: **(ours)**.
   */
  height_mm?: number;
  /**
   * The window's light; a spectrum's path is relative to this file. Allowed: "A", "C", "D50", "D55", "D65", "D75", "E", "FL1" to "FL12", "LED-B1" to "LED-B5", "LED-BH1", "LED-RGB1", "LED-V1", "LED-V2", a colour temperature from 1000K to 25000K, or a path ending in .csv. Source: CIE illuminants.
   */
  spectrum?: string;
  /**
   * Radiance, in units of white paper facing a lamp of intensity 1. Allowed: 0 to 1000000. Source: **(ours)**.
   */
  luminance?: number;
}
/**
 * The table that the pearl lies on.
 */
export interface Table {
  /**
   * No table, one colour, squares of two colours, or woven cloth. Allowed: "none", "plain", "checker" or "cloth". Source: paper 4.2, figure 12, a table mirrored in the pearl; its pattern is **(ours)**.
   */
  kind?: "none" | "plain" | "checker" | "cloth";
  /**
   * Colour of the table as sRGB. Allowed: "#rrggbb", six hexadecimal digits of sRGB. Source: **(ours)**.
   */
  colour?: string;
  /**
   * Colour of every other square, or of the gaps between the cloth's threads. Allowed: "#rrggbb", six hexadecimal digits of sRGB. Source: **(ours)**.
   */
  second_colour?: string;
  /**
   * Side of a square of the checker. Allowed: 0.1 to 1000 mm. Source: **(ours)**.
   */
  check_mm?: number;
  /**
   * Distance between the cloth's threads. Allowed: 0.05 to 100 mm. Source: **(ours)**.
   */
  weave_mm?: number;
}
/**
 * Four walls around the table; without this section there are none.
 */
export interface Walls {
  /**
   * Distance of each wall from the pearl's centre. Allowed: 20 to 100000 mm. Source: **(ours)**.
   */
  half_width_mm?: number;
  /**
   * Height of the walls above the table. Allowed: 1 to 100000 mm. Source: **(ours)**.
   */
  height_mm?: number;
  /**
   * Colour of the walls as sRGB. Allowed: "#rrggbb", six hexadecimal digits of sRGB. Source: **(ours)**.
   */
  colour?: string;
}
/**
 * What lies beyond table and walls.
 */
export interface Sky {
  /**
   * The horizon's colour everywhere, a gradient up to the zenith, or a panorama. Allowed: "constant", "gradient" or "panorama". Source: **(ours)**.
   */
  kind?: "constant" | "gradient" | "panorama";
  /**
   * Colour at the horizon as sRGB. Allowed: "#rrggbb", six hexadecimal digits of sRGB. Source: **(ours)**.
   */
  horizon?: string;
  /**
   * Colour overhead as sRGB. Allowed: "#rrggbb", six hexadecimal digits of sRGB. Source: **(ours)**.
   */
  zenith?: string;
  /**
   * Irradiance of a whole white sky on a surface facing up, in the lamps' unit. Allowed: 0 to 1000000. Source: **(ours)**.
   */
  intensity?: number;
  /**
   * High-range panorama in latitude and longitude; its path is relative to this file. Its middle lies at azimuth 180, straight ahead of a camera at azimuth 0. Allowed: a path ending in .hdr or .exr. Left out: no panorama. Source: **(ours)**.
   */
  path?: string;
  /**
   * Turn of the panorama about the y axis; seen from above, counter-clockwise. Allowed: -360 to 360 degrees. Source: **(ours)**.
   */
  rotation_deg?: number;
}
