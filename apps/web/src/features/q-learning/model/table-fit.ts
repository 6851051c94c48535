/** Columns and rows, with what parts them, in px. */
const CELL = 47
const HEADING = 34
/** Widths of a box, px: a little less than a finger where two columns fit then. */
const CELLS = [44, 41, 36]

/** How a table of all moves fits: a matrix, else rows, in two columns where boxes of `cell` px let both fit. */
export interface TableFit {
  readonly isMatrix: boolean
  readonly cell?: number | undefined
}

/** @param roads of each station how many, the closed ones too · @param width px · @param grid rooms have ways and no roads */
export function tableFit(roads: readonly number[], width: number, grid = false): TableFit {
  if (!grid && roads.length <= 10 && HEADING + roads.length * CELL <= width) return { isMatrix: true }
  return { isMatrix: false, cell: CELLS.find((cell) => widthOfTwo(roads, cell) <= width) }
}

function widthOfTwo(roads: readonly number[], cell: number): number {
  const half = Math.ceil(roads.length / 2)
  const halves = [roads.slice(0, half), roads.slice(half)]
  return halves.reduce((sum, some) => sum + 30 + Math.max(...some) * (cell + 3), 8)
}
