/** Line icons on a 24 px grid: `line` is drawn 2.2 px wide, `heavy` 3 px, `solid` is filled. */
const icons = {
  arrowLeft: { line: 'M20 12H5M11 6l-6.5 6 6.5 6' },
  arrowRight: { line: 'M4 12h15M13 6l6.5 6-6.5 6' },
  bin: { line: 'M4.5 7h15M9 7V4h6v3M6.5 7l1 13h9l1-13M10 11v5M14 11v5' },
  card: {
    line: 'M10.5 3.5h7a2.5 2.5 0 0 1 2.5 2.5v11a2.5 2.5 0 0 1 -2.5 2.5h-7a2.5 2.5 0 0 1 -2.5 -2.5v-11a2.5 2.5 0 0 1 2.5 -2.5zM5 7.5l-1.5.5 3 12.5 8.5-1',
  },
  check: { heavy: 'M5 12.5l4.5 4.5L19 7' },
  chevronDown: { line: 'M5 9l7 7 7-7' },
  chevronRight: { line: 'M9 5l7 7-7 7' },
  clock: { line: 'M4.5 13a7.5 7.5 0 1 0 15 0a7.5 7.5 0 1 0 -15 0zM12 9v4l2.5 2M9.5 2.5h5' },
  close: { line: 'M6 6l12 12M18 6L6 18' },
  cloud: { line: 'M7 18.5a4 4 0 0 1-.5-8 5.5 5.5 0 0 1 10.6-1A4.5 4.5 0 0 1 17 18.5zM9.5 13.5l2 2 3.5-3.5' },
  cloudOff: {
    line: 'M7 18.5a4 4 0 0 1-.5-8 5.5 5.5 0 0 1 10.6-1A4.5 4.5 0 0 1 17 18.5zM12 10v3.2M12 15.8v.1',
  },
  compass: {
    line: 'M3.5 12a8.5 8.5 0 1 0 17 0a8.5 8.5 0 1 0 -17 0zM15.5 8.5l-2 5-5 2 2-5z',
    solid: 'M15.5 8.5l-2 5-5 2 2-5z',
  },
  fill: { line: 'M14 4h6v6M10 20H4v-6M20 4l-7 7M4 20l7-7' },
  folder: { line: 'M3.5 18V6.5a2 2 0 0 1 2-2H9l2.5 2.5h7a2 2 0 0 1 2 2V18a2 2 0 0 1-2 2h-13a2 2 0 0 1-2-2z' },
  gear: {
    line: 'M8.8 12a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0 -6.4 0zM12 3v3M12 18v3M3 12h3M18 12h3M5.6 5.6l2.2 2.2M16.2 16.2l2.2 2.2M18.4 5.6l-2.2 2.2M7.8 16.2l-2.2 2.2',
  },
  home: { line: 'M4 11l8-7 8 7M6 9.5V20h12V9.5M10 20v-5.5h4V20' },
  menu: { line: 'M4 7h16M4 12h16M4 17h16' },
  minus: { line: 'M5 12h14' },
  mute: { line: 'M4 9.5v5h3.5L12 18.5v-13L7.5 9.5zM16 9.5l5 5M21 9.5l-5 5' },
  network: {
    line: 'M2.5 6.5a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0zM2.5 17.5a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0zM16.5 12a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0zM7.4 7.5l9.2 3.6M7.4 16.5l9.2-3.6',
  },
  pause: {
    solid:
      'M7.5 5h1.5a1.5 1.5 0 0 1 1.5 1.5v11a1.5 1.5 0 0 1 -1.5 1.5h-1.5a1.5 1.5 0 0 1 -1.5 -1.5v-11a1.5 1.5 0 0 1 1.5 -1.5zM15 5h1.5a1.5 1.5 0 0 1 1.5 1.5v11a1.5 1.5 0 0 1 -1.5 1.5h-1.5a1.5 1.5 0 0 1 -1.5 -1.5v-11a1.5 1.5 0 0 1 1.5 -1.5z',
  },
  people: {
    line: 'M5.5 8.5a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0zM2.5 19.5c.5-4 3-6 6.5-6s6 2 6.5 6M15.5 5.5a3.3 3.3 0 0 1 0 6.2M17.5 14c2.5.6 3.7 2.5 4 5.5',
  },
  play: { solid: 'M8 5.2v13.6c0 .8.9 1.3 1.6.8l10-6.8c.6-.4.6-1.2 0-1.6l-10-6.8C8.9 3.9 8 4.4 8 5.2z' },
  plus: { line: 'M12 5v14M5 12h14' },
  redo: { line: 'M15.5 5L20 9.5 15.5 14M19.5 9.5H10a5.5 5.5 0 0 0 0 11h3' },
  reset: { line: 'M4.5 12a7.5 7.5 0 1 0 2.6-5.7M4 3.5l2.8 3.1 3.7-1.7' },
  save: { line: 'M5 4h11l3.5 3.5V20H5zM8.5 4v5h6V4M8 20v-6.5h8.5V20' },
  shapes: {
    line: 'M3.5 8a4 4 0 1 0 8 0a4 4 0 1 0 -8 0zM15 12.5h4a1.5 1.5 0 0 1 1.5 1.5v4a1.5 1.5 0 0 1 -1.5 1.5h-4a1.5 1.5 0 0 1 -1.5 -1.5v-4a1.5 1.5 0 0 1 1.5 -1.5zM17 3.5l3.5 6h-7zM5 15.5h5v5H5z',
  },
  shrink: { line: 'M20 10h-6V4M4 14h6v6M14 10l6-6M10 14l-6 6' },
  sound: { line: 'M4 9.5v5h3.5L12 18.5v-13L7.5 9.5zM15.5 9c1.5 2 1.5 4 0 6M18 6.5c3 3.5 3 7.5 0 11' },
  sprout: {
    line: 'M12 20v-9M12 12c-4.5.5-7-2-7.5-6 4.5-.5 7 2 7.5 6zM12 14c.5-3.5 3-5.5 7.5-5-.5 4-3 5.5-7.5 5z',
  },
  step: {
    solid: 'M5 5.6v12.8c0 .8.9 1.2 1.5.8l8.5-6.4c.6-.4.6-1.2 0-1.6L6.5 4.8C5.9 4.4 5 4.8 5 5.6z',
    heavy: 'M18.5 5v14',
  },
  stop: {
    solid:
      'M8 5.5h8a2.5 2.5 0 0 1 2.5 2.5v8a2.5 2.5 0 0 1 -2.5 2.5h-8a2.5 2.5 0 0 1 -2.5 -2.5v-8a2.5 2.5 0 0 1 2.5 -2.5z',
  },
  undo: { line: 'M8.5 5L4 9.5 8.5 14M4.5 9.5H14a5.5 5.5 0 0 1 0 11h-3' },
  wrench: { line: 'M14.5 6.5a4 4 0 0 1 5-2l-2.5 2.5 1 1 2.5-2.5a4 4 0 0 1-5.3 5L8 18a2 2 0 0 1-2.5-2.5z' },
} as const satisfies Record<string, { line?: string; solid?: string; heavy?: string }>

export type IconName = keyof typeof icons

export function icon(name: IconName): {
  readonly line?: string
  readonly solid?: string
  readonly heavy?: string
} {
  return icons[name]
}
