/** Wheels of a move, −100..100. */
export interface Wheels {
  readonly left: number
  readonly right: number
}

const signs = {
  ahead: 'M0 8V-8M-6-2L0-8L6-2',
  back: 'M0-8V8M-6 2L0 8L6 2',
  left: 'M5 8V1Q5-5-1-5H-6M-2-9L-6-5L-2-1',
  right: 'M-5 8V1Q-5-5 1-5H6M2-9L6-5L2-1',
  stop: 'M-5.5-5.5H5.5V5.5H-5.5Z',
  aheadLeft: 'M4 8Q4-2-5-6M-6.5 0.5L-5-6L1.5-7.5',
  aheadRight: 'M-4 8Q-4-2 5-6M6.5 0.5L5-6L-1.5-7.5',
} as const

/** One third more on one wheel is a bend. */
const bend = 4 / 3

function kindOf({ left, right }: Wheels): keyof typeof signs {
  if (left === 0 && right === 0) return 'stop'
  if (left < 0 && right < 0) return 'back'
  if (left >= 0 && right >= 0 && left <= bend * right && right <= bend * left) return 'ahead'
  if (left > 0 && right > 0) return left < right ? 'aheadLeft' : 'aheadRight'
  return left < right ? 'left' : 'right'
}

/** Path data of the arrow of a move, about 0, 18 units high; ahead is up. Drawn with a line of 2.4 units. */
export const actionSign = (wheels: Wheels): string => signs[kindOf(wheels)]

const fills = ['#D4E6BC', '#D9CDF0', '#F8CFA5', '#BFE0EC', '#F3D0DC', '#EAE0A4'] as const

/** Colour of a move by its place among those that can be chosen. It never stands without the arrow or the name. */
export const actionFill = (index: number): string => fills[index % fills.length]!
