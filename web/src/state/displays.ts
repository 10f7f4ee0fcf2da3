// What takes a plan: displays, autopilots, programs and people; which file each wants, and how it gets there. As in docs/onto-the-machine.md.
import { t } from '../words';

export interface Wanted {
  /** Word of the server's address. */
  format: string;
  label: string;
  query?: Record<string, string>;
}
export interface Display {
  key: string;
  label: string;
  files: Wanted[];
  /** One after the other. */
  steps: string[];
  /** Guidance lines of it may be one for each subfield, or all. */
  lines?: true;
  /** A mission, which may be flown, or is always. */
  flown?: 'may be' | 'always';
}

const ISOXML_4: Wanted = { format: 'isoxml4', label: t`Task set, ISOXML 4` };
const ISOXML_3: Wanted = { format: 'isoxml3', label: t`Task set, ISOXML 3` };
const CARD: Wanted = { format: 'card', label: t`Line card, PDF` };
const UNPACKED = [
  t`Unpack the file at the top of an empty USB stick: a folder TASKDATA has to lie there, in capitals.`,
  t`Put the stick into the display, choose Import, then the field and its line.`,
];
const ZIPPED = [
  t`Copy the file to the top of a USB stick as it is, or send it by the office program.`,
  t`Put the stick into the display, choose Import, then the field and its line.`,
];

export const DISPLAYS: Display[] = [
  { key: 'fendt', label: 'Fendt (VarioDoc, FendtONE)', files: [ISOXML_4], steps: ZIPPED, lines: true },
  { key: 'massey', label: 'Massey Ferguson, Valtra', files: [ISOXML_4], steps: UNPACKED, lines: true },
  { key: 'pro1200', label: 'Case IH, New Holland, Steyr: Pro 1200', files: [ISOXML_4], steps: UNPACKED, lines: true },
  { key: 'pro700', label: 'Case IH, New Holland, Steyr: Pro 700', files: [ISOXML_3], steps: UNPACKED, lines: true },
  { key: 'claas', label: 'CLAAS S10, CEMIS', files: [ISOXML_4], steps: UNPACKED, lines: true },
  { key: 'cci', label: 'CCI 800, CCI 1200', files: [ISOXML_4], steps: UNPACKED, lines: true },
  { key: 'mueller', label: 'Müller-Elektronik', files: [ISOXML_4], steps: UNPACKED, lines: true },
  { key: 'trimble', label: 'Trimble Precision-IQ', files: [ISOXML_4], steps: UNPACKED, lines: true },
  { key: 'outback', label: 'Outback', files: [ISOXML_3], steps: UNPACKED, lines: true },
  {
    key: 'deere', label: 'John Deere Gen4, G5', files: [{ ...ISOXML_4, label: t`Boundary, ISOXML 4` }, CARD],
    steps: [t`Send the boundary by the office program.`, t`This display takes no guidance lines from files: type A and B from the line card.`],
  },
  { key: 'typed', label: t`A display without files`, files: [CARD], steps: [t`Print the card and type A and B, or A and the heading, into the display.`] },
  {
    key: 'agopengps', label: 'AgOpenGPS', files: [{ format: 'agopengps', label: t`Field folder of AgOpenGPS` }],
    steps: [t`Unpack the file into the folder Fields of AgOpenGPS.`, t`Open the field there with Open Field.`], lines: true,
  },
  {
    key: 'qgc', label: 'QGroundControl, PX4, ArduPilot', files: [{ format: 'mission', label: t`Mission, .plan` }],
    steps: [t`In QGroundControl choose Plan, File, Open.`, t`Look at the whole route there, then upload it to the vehicle.`], flown: 'may be',
  },
  {
    key: 'planner', label: 'Mission Planner', files: [{ format: 'waypoints', label: t`Mission, .waypoints` }],
    steps: [t`In Mission Planner choose Plan, Load File.`, t`Look at the whole route there, then write it to the vehicle.`], flown: 'may be',
  },
  {
    key: 'dji', label: 'DJI Pilot 2, DJI Fly', files: [{ format: 'dji', label: t`Flight route, .kmz` }],
    steps: [t`Copy the file to the remote control and import it under Flight route.`, t`It says way, height and speed, and not when to spray.`], flown: 'always',
  },
  {
    key: 'ros', label: t`A robot with ROS`, files: [{ format: 'ros-yaml', label: t`Route, YAML` }, { format: 'ros-json', label: t`Route, JSON` }],
    steps: [t`Its path is a nav_msgs/Path about the datum that the file names.`],
  },
  {
    key: 'gpx', label: t`A phone, or a handheld receiver`, files: [{ format: 'gpx', label: t`Route, GPX` }],
    steps: [t`Open the file on the device with an app that follows tracks.`],
  },
];

/** Of these nothing can be written without a route. */
const ROUTES = ['gpx', 'mission', 'waypoints', 'dji', 'ros-yaml', 'ros-json'];
export const needsRoute = ({ format }: Wanted) => ROUTES.includes(format);
/** Of a field in plain metres nothing can be written that says where on earth. */
export const needsEarth = ({ format }: Wanted) => !format.startsWith('ros-');

/** What the browser keeps the last display under. */
const KEEP = 'tramline-display';
export const lastDisplay = () => DISPLAYS.find(({ key }) => key === localStorage.getItem(KEEP))?.key ?? '';
export const keepDisplay = (key: string) => localStorage.setItem(KEEP, key);
