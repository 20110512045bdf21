// SVG paths of the icons, drawn as lines on a grid of 20 x 20 units.
import type { JSX } from "preact";

const PATHS = {
  undo: "M7 4 3.5 7.5 7 11M4 7.5h7.5a4.5 4.5 0 0 1 0 9H8",
  redo: "M13 4l3.5 3.5L13 11M16 7.5H8.500a4.5 4.5 0 0 0 0 9H12",
  camera: "M3 6.500h3.200L7.5 4.500h5l1.3 2H17v9.500H3zM10 8.500a2.8 2.8 0 1 0 0 5.6 2.8 2.8 0 0 0 0-5.600z",
  poster: "M4 4.5h9v7H4zM15 7.5h1.500v9H6.500V14M6 9.5l2-2 1.500 1.500L11 7.5l1 1",
  link: "M8.5 11.500a3 3 0 0 0 4.3 0l2.7-2.700a3 3 0 0 0-4.3-4.300L10 5.700M11.5 8.500a3 3 0 0 0-4.3 0l-2.7 2.700a3 3 0 0 0 4.3 4.300L10 14.3",
  help: "M7.5 7.500a2.5 2.5 0 1 1 3.6 2.250c-.8.4-1.1.9-1.1 1.750M10 14.400v.2M10 2.500a7.5 7.5 0 1 0 0 15 7.5 7.5 0 0 0 0-15z",
  theme: "M10 2.500a7.5 7.5 0 1 0 0 15 7.5 7.5 0 0 0 0-15zM10 2.500v15a7.5 7.5 0 0 0 0-15z",
  eye: "M2 10s3-5 8-5 8 5 8 5-3 5-8 5-8-5-8-5zM10 7.700a2.3 2.3 0 1 0 0 4.6 2.3 2.3 0 0 0 0-4.600z",
  hidden: "M2 10s3-5 8-5 8 5 8 5-3 5-8 5-8-5-8-5zM3.5 16.500l13-13",
  plus: "M10 4.500v11M4.5 10h11",
  close: "M5 5l10 10M15 5 5 15",
  copy: "M7.5 7.5h8v9h-8zM4.5 12.500v-9h8",
  play: "M6.5 4.500v11l9-5.500z",
  pause: "M7 4.500v11M13 4.500v11",
  next: "M6 5v10l6-5zM14.5 5v10",
  previous: "M14 5v10L8 10zM5.5 5v10",
  loop: "M4 8.500a4 4 0 0 1 4-4h7l-2.5-2.500M16 11.500a4 4 0 0 1-4 4H5l2.5 2.5",
  home: "M3.5 9.5 10 4l6.5 5.500M5.5 8v8h9V8",
  panel: "M3 4h14v12H3zM12.5 4v12",
  download: "M10 3.500v9M6.5 9 10 12.5 13.5 9M4 16.500h12",
  chevron: "M7 5l5 5-5 5",
  up: "M5 12l5-5 5 5",
  down: "M5 8l5 5 5-5",
  symmetric: "M10 4v8M6 8h8M6 15.500h8",
  hold: "M7 3.500h6l-1 5.500 2.500 2.500h-9L8 9zM10 11.500v5",
  reset: "M4.5 10a5.5 5.5 0 1 0 1.7-4M4.5 3.500v3h3",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name }: { name: IconName }): JSX.Element {
  return (
    <svg class="icon" viewBox="0 0 20 20" aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}
