// What the API gives and takes, as in openapi.json. Numbers are in the unit their name ends with.

export type Place = [lon: number, lat: number];
export type Box = [west: number, south: number, east: number, north: number];

export interface Geometry {
  type: 'Point' | 'LineString' | 'MultiLineString' | 'Polygon' | 'MultiPolygon' | 'MultiPoint';
  coordinates: unknown;
}
export interface Feature {
  type: 'Feature';
  id?: string | number;
  geometry: Geometry | null;
  properties: Record<string, unknown>;
}
export interface FeatureCollection {
  type: 'FeatureCollection';
  features: Feature[];
}

export interface ServerInfo {
  name: string;
  version: string;
  limits: { upload_bytes: number; streams: number; jobs: number };
  tiles: string | null;
  tiles_attribution: string | null;
  /** Where tiles of a file of the server lie, and their levels. */
  tiles_of: { bbox: Box; first_zoom: number; last_zoom: number } | null;
}

export interface UploadedFeature {
  fid: number;
  layer?: string;
  id: string;
  area_m2: number;
  obstacles: number;
  refused: string | null;
  rings: Geometry | Place[][] | null;
  /** What people call it, by its attributes. */
  name?: string;
  crop?: string;
  attributes?: Record<string, string>;
}
export interface UploadedLog {
  name: string;
  fixes: number;
  from_s: number | null;
  to_s: number | null;
  /** Where it was driven; null in plain metres. */
  bbox: Box | null;
  width_m: number | null;
  refused?: string | null;
}
export interface Upload {
  id: string;
  name: string;
  bytes: number;
  kind: 'fields' | 'log' | 'plan' | 'unknown';
  message?: string;
  features?: UploadedFeature[];
  features_total?: number;
  logs?: UploadedLog[];
  /** A task set may hold logs and fields. */
  partfields?: UploadedFeature[];
}

export interface FieldItem {
  id: string;
  name: string;
  area_m2: number;
  obstacles: number;
  passable: number;
  geodetic: boolean;
  bbox: Box;
  created: string;
  crop: string;
  tags: string[];
  /** Only in the list: few corners, for a map of all fields. */
  outline?: Geometry;
  last_plan?: { id: string; created: string; width_m: number; hours: number | null; euros: number | null } | null;
}
export interface Repair {
  what: string;
  where: string;
  area_change_m2?: number;
}
export interface Skipped {
  what: string;
  where: string;
  why: string;
}
export interface FieldFull extends FieldItem {
  repairs: Repair[];
  skipped: Skipped[];
  warnings: string[];
  shapes: FeatureCollection;
}
export interface ObstacleDrawn {
  kind: 'obstacle' | 'passable';
  geometry: Geometry;
  size_m?: number;
}

export interface Machine {
  id?: string;
  name?: string;
  width_m: number;
  radius_m: number;
  min_length_m?: number | null;
  /** What it needs to turn; the form keeps it as it came. */
  turning?: Record<string, unknown>;
  rates?: Rates;
}
/** What the work costs; what is missing is as usual for the operation. */
export interface Rates {
  operation?: string;
  price_per_hour?: number;
  fuel_l_per_h?: number;
  fuel_price?: number;
  sections?: number;
  input_price_per_ha?: number;
  margin_per_ha?: number;
  price_per_stop?: number;
}
export type RateKey = Exclude<keyof Rates, 'operation'>;
export interface Operation {
  operation: string;
  working_speed_mps: number;
  standing_crop: boolean;
  rates: Required<Rates>;
}

export interface Prices {
  overlap: number;
  uncovered: number;
  turn: number;
  stop: number;
  subfield: number;
}
export type EndRule = 'cheapest' | 'centre' | 'cover' | 'inside';
/** Drawn on a field for a plan: a subfield, a line to cut along, land that no swath enters, or land that need not be worked. */
export interface Land {
  kind: 'subfield' | 'cut' | 'skip' | 'done';
  geometry: Geometry;
  direction_deg?: number;
  /** What the tracks of a subfield follow. */
  guide?: Place[];
}
export interface PlanSettings {
  land?: Land[];
  strategy?: 'best' | 'sweep';
  end_rule?: EndRule;
  boundary?: 'soft' | 'hard';
  /** A number of passes, or as many as turns need. */
  headlands?: number | 'auto';
  obstacle_headlands?: number | 'auto';
  curved?: 'auto' | 'always' | 'never';
  line?: Place[];
  avoid?: 'cheapest' | 'paper' | 'cut';
  clearance_m?: number;
  /** The whole route; what follows is about it. */
  route?: boolean;
  order?: string;
  headland_time?: 'first' | 'last';
  pass_corners?: 'auto' | 'round';
  start?: Place;
  end?: Place;
}
export interface PlanRequest {
  field: string;
  machine: Machine;
  /** Of tracks alone. Without it the whole route counts, by the rates of the machine. */
  objective?: { prices: Prices };
  settings: PlanSettings;
  explain?: boolean;
  /** The next draft of the field replaces it, unless the user wants it. */
  draft?: boolean;
  /** The search ends then with the best plan that it has. */
  seconds?: number;
  name?: string;
  /** The plan that this one is an edit of: its headland passes, and the directions that nothing else decides, are kept. */
  edit_of?: string;
}

export type JobRequest =
  | ({ kind: 'plan' | 'compare' } & PlanRequest)
  | { kind: 'evaluate'; drive: string; options?: DriveOptions }
  | { kind: 'repair'; drive: string; machine: Machine; min_area_m2?: number }
  | { kind: 'check'; plan: string };
export interface JobResult {
  plan?: string;
  front?: string;
  drive?: string;
  report?: Record<string, unknown> | Record<string, unknown>[];
  check?: Check;
}
/** What the verifier found when it worked the plan out anew. */
export interface Check {
  ok: boolean;
  complete: boolean;
  violations: CheckedPlace[];
  /** What the plan does not promise, such as that the detours of a paper can be driven. */
  findings: CheckedPlace[];
  recomputed: Checked | null;
  stored: Checked;
}
export interface CheckedPlace {
  rule: string;
  what: string;
  amount: number;
  at: Place;
}
export interface Checked {
  overlap_m2: number;
  uncovered_m2: number;
  worked_m2: number;
  turns: number;
  stops: number;
  tracks: number;
  track_length_m: number;
}
export interface Job {
  id: string;
  kind: string;
  state: 'queued' | 'running' | 'done' | 'failed' | 'cancelled';
  what: string;
  /** Empty where it works on none. */
  field: string;
  done: number;
  total: number;
  seconds: number;
  result: JobResult | null;
  error: { code: string; message: string } | string | null;
}

export interface Tally {
  overlap_m2: number;
  uncovered_m2: number;
  turns: number;
  stops: number;
  cost: number;
}
export interface PlanItem extends Tally {
  id: string;
  name: string;
  field: string;
  created: string;
  tracks: number;
  width_m: number;
  kind: string;
  draft: boolean;
  /** The field has another shape now. */
  earlier_shape: boolean;
  /** Null where it has no route. */
  route: { hours: number; litres: number; euros: number } | null;
}
export type LegKind = 'work' | 'headland' | 'turn' | 'transit' | 'back_out';
export interface Leg {
  seq: number;
  kind: LegKind;
  gear: 'forward' | 'reverse';
  work: boolean;
  length_m: number;
  time_s: number;
  missing_m?: number;
}
export interface Route {
  legs: Leg[];
  length_m: number;
  reverse_m: number;
  time_s: number;
  back_outs: number;
  /** What each of them counts in the bound besides its time. */
  stop_s: number;
  /** What time and stops come to at least on every route over the same tracks and passes. */
  bound_s: number;
  gap: number;
  without_room: number;
  over_worked_m: number;
  over_unworked_m: number;
  over_tracks_m: number;
}
/** What driving the whole route takes, and what the plan does to the land, by the rates of its machine. */
export interface WholeCost {
  euros: number;
  hours: number;
  litres: number;
  working_h: number;
  headland_h: number;
  turning_h: number;
  transit_h: number;
  not_working_share: number;
  field_efficiency: number;
  euros_hours: number;
  euros_fuel: number;
  euros_overlap: number;
  euros_missed: number;
  euros_stops: number;
  euros_driven_over: number;
  euros_without_room: number;
  rates: Required<Rates>;
}
export interface PlanSummary extends Tally {
  area_m2: number;
  body_m2: number;
  width_m: number;
  radius_m: number;
  end_rule: EndRule;
  direction_deg: number[];
  subfields: number;
  tracks: number;
  track_length_m: number;
  detours: number;
  headland_passes: number;
  headland_m2: number;
  headland_length_m: number;
  given_up_m2: number;
  bound: number | null;
  gap: number | null;
  kind: string;
  /** The part of the overlap beyond the boundary. */
  outside_m2: number;
  headland_overlap_m2: number;
  headland_uncovered_m2: number;
  /** Only of plans that have one. */
  route?: Route;
  whole_cost?: WholeCost;
  seconds?: number;
  /** The search ended before it was through. */
  cut_short?: boolean;
  repairs?: Repair[];
  skipped?: Skipped[];
  dropped?: { length_m: number }[];
  warnings?: string[];
}
export interface Cause {
  cause: string;
  overlap_m2: number;
  uncovered_m2: number;
  count: number | null;
  cost: number;
}
export interface RunnerUp extends Tally {
  direction_deg: number[];
  subfields: number;
  more: number;
  more_by: { overlap: number; uncovered: number; turns: number; stops: number };
  main_reason: string;
}
/** A plan whose whole route was compared with that of the plan. */
export interface ComparedRoute {
  kind: string;
  directions_deg: number[];
  headlands: number;
  all_round: boolean;
  hours: number;
  euros: number;
  without_room: number;
  /** Pieces that are not worth the way to them. */
  dropped: number;
}
export interface Explain {
  causes?: Cause[];
  runner_ups?: RunnerUp[];
  /** Of plans of least whole cost; the plan itself comes first. */
  routes?: ComparedRoute[];
  /** Of a plan for gaps: what they cost left as they are, and what it costs to work them. */
  repair?: { missed_before_m2: number; missed_after_m2: number; cost_if_left: number; cost_of_passes: number; cost_after: number };
}
/** A request as it was made; what it left out is as the server takes it. */
export interface Asked {
  machine: Machine;
  objective?: { prices: Prices };
  settings?: PlanSettings;
  edit_of?: string;
}
export interface PlanFull {
  id: string;
  name: string;
  field: string;
  created: string;
  kind: string;
  draft: boolean;
  summary: PlanSummary;
  explain: Explain | null;
  asked: Asked | null;
  /** The field has another shape now. */
  earlier_shape: boolean;
  /** Of the fuel at work, with the work off. */
  idle_fuel_share: number;
  /** The longest first. */
  headland_sides: HeadlandSide[];
  bbox: Box;
}
/** A side of the field, from corner to corner or to where the number of passes changes. */
export interface HeadlandSide {
  length_m: number;
  /** Null of the whole boundary. */
  bearing_deg: number | null;
  passes: number;
  depth_m: number;
}
export interface LayerItem {
  name: string;
  title: string;
  features: number;
  m2: number | null;
  m: number | null;
}

export interface FrontPoint extends Tally {
  point: number;
  tracks: number;
  track_length_m: number;
  subfields: number;
  direction_deg: number[];
  marks: string[];
}
export interface Front {
  field_id: string;
  area_m2: number;
  width_m: number;
  end_rule: EndRule;
  front: FrontPoint[];
}

/** How a log is read and its land worked out; what is missing is as the server takes it. */
export interface DriveOptions {
  engine?: 'exact' | 'mesh';
  mesh_m?: number;
  quads?: 'heading' | 'segment';
  repeat?: 'run' | 'strict';
  headings?: HeadingReading;
  switch?: 'interpolate' | 'step';
  max_gap_s?: number;
  max_step_m?: number;
  antenna_forward_m?: number;
  antenna_right_m?: number;
  implement_behind_m?: number;
  columns?: string;
  log_crs?: string;
}
export type HeadingReading = 'compass' | 'math' | 'from-track';
export interface MeshCount {
  now: number;
  most: number;
}
export interface Meshes {
  side_m: number;
  covered: MeshCount;
  missed: MeshCount | null;
}
/** Headings of a log that contradict the way driven. */
export interface HeadingContradiction {
  read_as: HeadingReading;
  steps: number;
  off: number;
  share: number;
  first: { record: number; time_s: number | null; at: Place };
  better: HeadingReading;
  better_off: number;
}

export interface DriveItem {
  id: string;
  name: string;
  field: string | null;
  created: string;
  fixes: number;
  from_s: number | null;
  to_s: number | null;
  covered_m2: number;
  missed_m2: number | null;
}
export interface Gap {
  number: number;
  area_m2: number;
  lon: number;
  lat: number;
  widest_m: number;
}
export interface DriveSummary {
  field_area_m2: number | null;
  width_m: number;
  fixes: number;
  fixes_used: number;
  covered_m2: number;
  covered_inside_m2: number | null;
  outside_m2: number | null;
  repeated_m2: number;
  repeated_rate: number;
  missed_m2: number | null;
  not_recorded_m2?: number;
  worked_hours: number | null;
  ha_per_hour: number | null;
  skipped_count?: number;
  meshes?: Meshes;
  headings?: HeadingContradiction;
  warnings?: string[];
  plan?: Compared;
}
export interface Compared {
  planned_m2?: number;
  planned_missed_m2?: number;
  unplanned_m2?: number;
  along_tracks_m?: number;
  beside_tracks_m?: number;
  followed?: boolean;
  followed_share?: number;
  median_distance_m?: number | null;
  median_angle_deg?: number | null;
  deviation_mean_m?: number | null;
  deviation_p95_m?: number;
  deviation_most_m?: number;
}
export interface DriveFull {
  id: string;
  name: string;
  field: string | null;
  created: string;
  bbox: Box | null;
  from_s: number | null;
  to_s: number | null;
  /** Where the log has no times, from_s and to_s are numbers of fixes. */
  clock?: 'none' | 'utc' | 'of_day' | 'other';
  summary: DriveSummary;
  options: DriveOptions;
  gaps: Gap[];
  compared: Compared | null;
}
export interface DriveRequest {
  upload: string;
  log?: string;
  field?: string;
  plan?: string;
  width_m?: number;
  name?: string;
  options?: DriveOptions;
}
export interface FeedRequest {
  source: string;
  field?: string;
  width_m?: number;
  name?: string;
  options?: DriveOptions;
}
export interface FeedItem {
  id: string;
  name?: string;
  source?: string;
  field?: string | null;
}

export interface WorkFigures {
  covered_m2: number;
  covered_inside_m2: number | null;
  outside_m2: number | null;
  repeated_m2: number;
  missed_m2: number | null;
  worked_s: number;
  ha_per_hour: number | null;
  remaining_s: number | null;
  meshes?: Meshes;
}
export interface WorkTile {
  id: string;
  covered: Place[][][];
  repeated: Place[][][];
}
/** How the receiver came by a position. */
export type FixQuality = 'single' | 'differential' | 'rtk float' | 'rtk fixed' | 'estimated';
export interface WorkFrame {
  time_s: number | null;
  fix: number;
  fixes: number;
  at: Place | null;
  heading_deg: number | null;
  working: boolean;
  quality: FixQuality | null;
  figures: WorkFigures;
  line: Place[];
  all: boolean;
  tiles: WorkTile[];
}
