import type { PaneName, PaneSizes } from '#lab/panes.ts'

/** columns: three side by side · stacked: program left, world over network · rows: world and network over program · pages: one at a time. */
export type Arrangement = 'columns' | 'stacked' | 'rows' | 'pages'

/** A border between panes that can be dragged: where it stands in px from the left or the top, and how far it may go. */
export interface Border {
  readonly axis: 'x' | 'y'
  readonly at: number
  readonly min: number
  readonly max: number
}

export interface Area {
  readonly width: number
  readonly height: number
}

/** Between panes, in px. */
export const gap = 8
const least = {
  program: 340,
  world: 300,
  network: 340,
  worldHeight: 180,
  networkHeight: 220,
  programHeight: 200,
}
/** visual.md 3: what the designed screens give the panes, in px of the lab without its sides. */
const designed = { free: 1330, program: 452, world: 396, network: 482, programMost: 560, worldMost: 760 }

export const isLow = ({ height }: Area): boolean => height < 520

/** Of the whole window, in px. A low window (a turned phone, 200 % zoom) shows one pane at a time too. */
export function arrangementOf(window: Area): Arrangement {
  if (window.width < 640 || isLow(window)) return 'pages'
  if (window.width < 1000) return 'rows'
  return window.width < 1280 ? 'stacked' : 'columns'
}

/** So little room (400 % zoom) that the lab is a page that scrolls: its bars alone would fill the window. */
export const scrollsAsPage = ({ width, height }: Area): boolean =>
  height < 300 || (width < 560 && height < 480)

/** The pane that comes after this one, or before it; the first from outside of all. */
export function nextPane(panes: readonly PaneName[], here: PaneName | null, back: boolean): PaneName {
  if (here === null) return panes.at(back ? -1 : 0)!
  return panes[(panes.indexOf(here) + (back ? -1 : 1) + panes.length) % panes.length]!
}

function border(axis: 'x' | 'y', wanted: number, min: number, max: number): Border {
  const most = Math.max(min, max)
  return { axis, at: Math.round(Math.min(most, Math.max(min, wanted))), min, max: Math.round(most) }
}

/** visual.md 3: from 1600 on the world grows first, then the network; the program at most 560. */
function columnsDesigned(free: number): readonly [program: number, world: number] {
  const scale = free / designed.free
  if (scale <= 1) return [designed.program * scale, designed.world * scale]
  const program = Math.min(designed.program * scale, designed.programMost)
  return [program, Math.min(free - program - designed.network, designed.worldMost)]
}

/** What stands in the third pane. */
export type Third = 'network' | 'code' | 'tried'

/** What was learned by trying is few blocks, and much to see in the world. */
const columnsTried = (free: number): readonly [program: number, world: number] => [0.265 * free, 0.375 * free]

/** Code wants room for its longest lines, beside its blocks. The second border is the code's. */
const columnsCode = (free: number): readonly [program: number, code: number] => [
  Math.min(0.305 * free, designed.programMost),
  Math.min(0.415 * free, 820),
]

function columns(area: Area, sizes: PaneSizes['columns'], third: Third): readonly [Border, Border] {
  const free = area.width - 2 * gap
  const code = third === 'code'
  const asDesigned = { network: columnsDesigned, code: columnsCode, tried: columnsTried }[third](free)
  const wanted = sizes ? [sizes[0] * area.width, sizes[1] * area.width] : asDesigned
  const [middle, right] = code ? [least.network, least.world] : [least.world, least.network]
  const program = border('x', wanted[0] ?? 0, least.program, free - middle - right)
  return [program, border('x', wanted[1] ?? 0, middle, free - program.at - right)]
}

function stacked(area: Area, sizes: PaneSizes['stacked'], third: Third): readonly [Border, Border] {
  const [program, world] = sizes ?? (third === 'code' ? [0.442, 0.3] : [0.456, 0.435])
  return [
    border('x', program * area.width, least.program, area.width - gap - least.network),
    border('y', world * area.height, least.worldHeight, area.height - gap - least.networkHeight),
  ]
}

function rows(area: Area, sizes: PaneSizes['rows']): readonly [Border, Border] {
  const [world, upper] = sizes ?? [0.495, 0.5]
  return [
    border('x', world * area.width, least.world, area.width - gap - least.world),
    border('y', upper * area.height, least.networkHeight, area.height - gap - least.programHeight),
  ]
}

/** The two borders of an arrangement, as the child has dragged them or as they are designed; none when panes are pages. */
export function bordersOf(
  arrangement: Arrangement,
  area: Area,
  sizes: PaneSizes,
  third: Third = 'network',
): readonly Border[] {
  if (arrangement === 'columns') return columns(area, sizes.columns, third)
  if (arrangement === 'stacked') return stacked(area, sizes.stacked, third)
  return arrangement === 'rows' ? rows(area, sizes.rows) : []
}

/** The sizes after border `index` was put at `at` px. */
export function moved(
  arrangement: Exclude<Arrangement, 'pages'>,
  area: Area,
  borders: readonly Border[],
  index: number,
  at: number,
): PaneSizes {
  const shares = borders.map((border, i) => {
    const px = i === index ? Math.min(border.max, Math.max(border.min, at)) : border.at
    return px / (border.axis === 'x' ? area.width : area.height)
  })
  return { [arrangement]: [shares[0] ?? 0, shares[1] ?? 0] }
}

/** Where a key puts a border; undefined: the key is not for it. `far`: in large steps. */
export function byKey({ axis, at, min, max }: Border, key: string, far: boolean): number | undefined {
  const [less, more] = axis === 'x' ? ['ArrowLeft', 'ArrowRight'] : ['ArrowUp', 'ArrowDown']
  const step = far ? 64 : 16
  const places: { [key: string]: number } = { [less]: at - step, [more]: at + step, Home: min, End: max }
  return places[key]
}

const rest = 'minmax(0, 1fr)'

/** `grid-template` where there is no network to show: the program as it is with one, the world has the rest. */
export function gridOfTwo(arrangement: Arrangement, borders: readonly Border[]): string {
  const [first, second] = borders.map((border) => `${border.at}px`)
  if (arrangement === 'pages') return `${rest} / ${rest}`
  if (arrangement === 'rows') return `"world" ${second} "first" ${gap}px "program" ${rest} / ${rest}`
  return `"program first world" ${rest} / ${first} ${gap}px ${rest}`
}

/** `grid-template` of an arrangement. */
export function gridOf(
  arrangement: Arrangement,
  borders: readonly Border[],
  third: Third = 'network',
): string {
  const [a, b] = borders.map((border) => `${border.at}px`)
  switch (arrangement) {
    case 'columns':
      // Code stands beside its blocks.
      if (third === 'code')
        return `"program first network second world" ${rest} / ${a} ${gap}px ${b} ${gap}px ${rest}`
      return `"program first world second network" ${rest} / ${a} ${gap}px ${b} ${gap}px ${rest}`
    case 'stacked':
      return `"program first world" ${b} "program first second" ${gap}px "program first network" ${rest} / ${a} ${gap}px ${rest}`
    case 'rows':
      return `"world first network" ${b} "second second second" ${gap}px "program program program" ${rest} / ${a} ${gap}px ${rest}`
    case 'pages':
      return `${rest} / ${rest}`
  }
}
