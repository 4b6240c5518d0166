/* Made by ./just types, never by hand. SHA-256 of its schema:
 * b66089431632bca1175de3c2a21a4d19f890b8eaf0ce22130688658b10f39731
 */

export interface Blemishes {
  seed: number | bigint | null;
  pits: number;
  bumps: number;
  scratches: number;
  wrinkles: number;
  chalky_spots: number;
  size_mm: number;
  depth_um: number;
  area: number | null;
}
export interface Body {
  pigment: "none" | "white" | "cream" | "pink" | "gold" | "black-lip" | "dyed-blue";
  pigment_strength: number;
  nacre_mm: number | null;
  scattering_per_mm: number;
  nucleus: string;
  nucleus_bands: number;
  nucleus_band_mm: number;
}
export interface Camera {
  projection: "orthographic" | "perspective";
  elevation_deg: number;
  azimuth_deg: number;
  field_mm: number | null;
  distance_mm: number;
  exposure: number;
  glare: number;
  glare_deg: number;
  white: string;
}
export interface Coat {
  seed: number | bigint | null;
  thickness_spread: number;
  patch_mm: number;
  banding: number;
  liveliness: number;
  hammering_rad: number;
  dent_mm: number;
  grain_relief_rad: number | null;
  terrace_um: number;
  terrace_step_nm: number;
}
export interface Film {
  outer_um: number | null;
  columns: number;
  column_spread_nm: number | null;
}
export interface Growth {
  protein_nm: number;
  aragonite:
    | (
        | number
        | [number, number]
        | ("aragonite" | "aragonite-isotropic-1.53" | "chitin" | "silk-fibroin" | "protein-1.43")
      )
    | Uniaxial;
  protein:
    | (
        | number
        | [number, number]
        | ("aragonite" | "aragonite-isotropic-1.53" | "chitin" | "silk-fibroin" | "protein-1.43")
      )
    | Uniaxial;
  preset: string;
  seed: number | bigint;
  seeding: string;
  harvest: string;
  peak: string;
  season_days: number;
  thickness_winter_nm: number;
  thickness_summer_nm: number;
  layers_winter: number;
  layers_summer: number;
  thickness_noise_nm: number;
  layers_noise: number;
}
export interface Uniaxial {
  n_o: number;
  n_e: number;
}
export interface Inside {
  spread: number | null;
}
export interface Interference {
  coherence_nm: number;
  threshold: number;
  diffuse_loss: number | null;
  mixing: number | null;
}
export interface Lamp {
  azimuth_deg: number | null;
  elevation_deg: number | null;
  position_mm: [number, number, number] | null;
  angular_radius_deg: number;
  spectrum: string;
  intensity: number;
}
export interface Layers {
  protein_nm: number;
  aragonite:
    | (
        | number
        | [number, number]
        | ("aragonite" | "aragonite-isotropic-1.53" | "chitin" | "silk-fibroin" | "protein-1.43")
      )
    | Uniaxial;
  protein:
    | (
        | number
        | [number, number]
        | ("aragonite" | "aragonite-isotropic-1.53" | "chitin" | "silk-fibroin" | "protein-1.43")
      )
    | Uniaxial;
  thickness_nm: number[];
}
export interface Pearl {
  name: string;
  model: "transport" | "illuminant";
  diameter_mm: number;
  body_colour?: string;
  depth: number;
  shininess: number;
  grain: number;
  nacre: Growth | Layers;
  film?: Film;
  body?: Body;
  inside?: Inside;
  interference?: Interference;
  surface: Surface;
  texture: Texture;
  coat?: Coat;
  blemishes?: Blemishes;
  shape?: Shape;
  pose?: Pose;
}
export interface Surface {
  facet_spread_rad: number | null;
  mirror_weight?: number | null;
  layer_reflectance?: number;
  falloff_mm?: number;
  facets?: "torrance-sparrow" | "ggx";
  waviness_rad?: number;
}
export interface Texture {
  source: string;
  mm_per_pixel: number | null;
  side_px: number;
  low_per_mm: number | null;
  high_per_mm: number | null;
  seed: number | bigint | null;
  hue_weight: number | null;
  chroma_weight: number | null;
  value_weight: number | null;
}
export interface Shape {
  seed: number | bigint | null;
  length: number;
  taper: number;
  flattening: number;
  out_of_round: number;
  lumps: number;
  lump_mm: number | null;
  circles: number;
  circle_depth: number;
  drill_mm: number;
  drill_wear_mm: number;
}
export interface Pose {
  turn_deg: number;
  tilt_deg: number | null;
  spin_deg: number;
}
export interface Row {
  pearls: string[];
  form: "line" | "neck";
  label: string | null;
}
export interface Scene {
  name: string;
  observer: "1931-2" | "1964-10";
  pitch_mm: number | null;
  row_gap_mm: number | null;
  camera: Camera;
  lamps: Lamp[];
  windows: Window[];
  rows: Row[];
  table: Table;
  walls: Walls | null;
  sky: Sky;
}
export interface Window {
  azimuth_deg: number | null;
  elevation_deg: number | null;
  distance_mm: number | null;
  position_mm: [number, number, number] | null;
  facing: [number, number, number] | null;
  below_mm: number | null;
  width_mm: number;
  height_mm: number;
  spectrum: string;
  luminance: number;
}
export interface Table {
  kind: "none" | "plain" | "checker" | "cloth";
  colour: string;
  second_colour: string;
  check_mm: number;
  weave_mm: number;
}
export interface Walls {
  half_width_mm: number;
  height_mm: number;
  colour: string;
}
export interface Sky {
  kind: "constant" | "gradient" | "panorama";
  horizon: string;
  zenith: string;
  intensity: number;
  path: string | null;
  rotation_deg: number;
}
