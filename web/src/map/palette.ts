// The colours of the library's pictures (src/tramline/model/palette.h; a test holds the two together), and
// what takes their place at night, where the ground is dark.

export const PICTURE = {
  Background: '#FFFFFF',
  Overlap: '#E66100',
  Uncovered: '#0A4FD6',
  Ink: '#1E2420',
  FaintInk: '#5A635C',
  Rule: '#C9CDC6',
  Field: '#F1EFE8',
  Headland: '#DEDACF',
  HeadlandPass: '#7A4E1D',
  Reference: '#00695C',
  FieldEdge: '#2F3B2F',
  SubfieldEdge: '#6B7266',
  Obstacle: '#4C4A48',
  ObstacleHatch: '#8E8A86',
  Passable: '#CFE8C4',
  PassableHatch: '#2E8B3D',
  Track: '#3A463B',
  Dropped: '#6E6E6E',
  Detour: '#9A0F72',
  Covered: '#BFDDA9',
  CoveredOutside: '#E4F0DA',
  CoveredEdge: '#86AE6B',
  TwiceHatch: '#8A3B00',
  NotRecorded: '#F2C500',
  NotRecordedHatch: '#1E2420',
  WorkedPath: '#26402A',
  IdlePath: '#7B7B7B',
} as const;

export const TINTS = ['#E2EDD5', '#F4EACB', '#E7DFF0', '#F3DDDB', '#D3EAE5', '#EAE9C4', '#DCE3EC', '#EADCCB'] as const;

export type Colours = Record<keyof typeof PICTURE, string> & { Tints: readonly string[]; Backdrop: string; Grid: string; GridStrong: string; Rim: string };

export const DAY: Colours = { ...PICTURE, Tints: TINTS, Backdrop: '#FAFAF7', Grid: '#E6E7E1', GridStrong: '#D3D6CE', Rim: '#FFFFFF' };

/** Orange, blue and purple keep their hues and get lighter; ground and ink change places. */
export const NIGHT: Colours = {
  ...PICTURE,
  Background: '#0F1416',
  Overlap: '#FF8A3D',
  Uncovered: '#5C93FF',
  Ink: '#EEF2EE',
  FaintInk: '#B4BEB7',
  Rule: '#39444A',
  Field: '#27302D',
  Headland: '#363A33',
  HeadlandPass: '#D9A566',
  Reference: '#4FD1BD',
  FieldEdge: '#C9D3CB',
  SubfieldEdge: '#8D978F',
  Obstacle: '#97928D',
  ObstacleHatch: '#5E5A56',
  Passable: '#2C4A33',
  PassableHatch: '#6BC27B',
  Track: '#C5D0C7',
  Dropped: '#8C8C8C',
  Detour: '#FF7AD0',
  Covered: '#3F6B36',
  CoveredOutside: '#2C4428',
  CoveredEdge: '#6D9A58',
  TwiceHatch: '#FFB27A',
  NotRecorded: '#C9A400',
  WorkedPath: '#D9F0C8',
  IdlePath: '#9A9A9A',
  Tints: ['#2C3A2A', '#3B3626', '#332D3D', '#3B2E2D', '#25393A', '#36361F', '#2B333C', '#3A3229'],
  Backdrop: '#0F1416',
  Grid: '#1B2326',
  GridStrong: '#283236',
  Rim: '#0F1416',
};
