/** In px. */
export interface Area {
  readonly width: number
  readonly height: number
}

/**
 * columns: program, map, table · side: the table slides in at the left, over start and goal · tower: the map
 * is above everything else.
 */
export interface MapFirst {
  readonly form: 'columns' | 'side' | 'tower'
  /** The bar of buttons is below the map, or in the column next to it. */
  readonly bar: 'below' | 'beside'
  /** Px of the column at the left: program, start and goal. */
  readonly rail: number
  /** Px of the column at the right; 0: there is none. */
  readonly table: number
}

/** The share of the window that a map has. */
export const SHARE = 0.45
export const GAP = 8
/** The bar in one row, with its gap. */
const BAR = 67
/** The height that a tower needs below map and bar. */
const BELOW = 330
const rail = { columns: 132, least: 176, most: 316, open: 346 }
const table = { least: 335, most: 446 }

interface Choice {
  readonly form: MapFirst['form']
  readonly bar: MapFirst['bar']
  /** The largest area that the map can have. */
  readonly free: Area
}

const areaOf = ({ width, height }: Area, ratio: number) => Math.min(width, height * ratio) ** 2 / ratio

function choicesIn({ width, height }: Area): readonly Choice[] {
  const columns = width - rail.columns - table.least - 2 * GAP
  const side = width - rail.least - GAP
  return [
    { form: 'columns', bar: 'below', free: { width: columns, height: height - BAR } },
    { form: 'columns', bar: 'beside', free: { width: columns, height } },
    { form: 'side', bar: 'below', free: { width: side, height: height - BAR } },
    { form: 'side', bar: 'beside', free: { width: side, height } },
    { form: 'tower', bar: 'below', free: { width, height: height - BAR - BELOW } },
  ]
}

const clamp = (value: number, least: number, most: number) =>
  Math.round(Math.max(least, Math.min(most, value)))

/**
 * Arranges the playground so that the map has its share of the window, or as much as its shape allows.
 * @param room of the playground · @param ratio width by height of the map · @param open the table is slid in
 */
export function mapFirst(room: Area, window: Area, ratio: number, open: boolean): MapFirst {
  const wanted = SHARE * 1.002 * window.width * window.height
  const choices = choicesIn(room).filter(({ free }) => free.width > 0 && free.height > 0)
  const most = Math.max(...choices.map(({ free }) => areaOf(free, ratio)))
  const { form, bar } = choices.find(({ free }) => areaOf(free, ratio) >= Math.min(wanted, most)) ?? {
    ...({ form: 'tower', bar: 'below' } as const),
  }
  // The map has at least this width; the columns share the rest, as far as they can use it.
  const width = Math.sqrt(Math.min(wanted, most) * ratio)
  if (form === 'columns') {
    const rest = room.width - rail.columns - width - 2 * GAP
    return { form, bar, rail: rail.columns, table: clamp(rest, table.least, table.most) }
  }
  if (form === 'tower') return { form, bar, rail: clamp(room.width * 0.27, 150, rail.most), table: 0 }
  const rest = clamp(room.width - width - GAP, rail.least, rail.most)
  // A table needs the height that the bar would take from its column.
  return open
    ? { form, bar: 'below', rail: Math.max(rest, rail.open), table: 0 }
    : { form, bar, rail: rest, table: 0 }
}
