import { colours, nearestOption } from '@botgarten/blocks'

interface Named {
  readonly pybricks: string
  readonly ev3dev2: string
}

/** The colours of the blocks in each library. Grey is what both say where they see none. */
const names: { readonly [colour: string]: Named } = {
  '#000000': { pybricks: 'BLACK', ev3dev2: 'COLOR_BLACK' },
  '#0057A6': { pybricks: 'BLUE', ev3dev2: 'COLOR_BLUE' },
  '#00642E': { pybricks: 'GREEN', ev3dev2: 'COLOR_GREEN' },
  '#F7D117': { pybricks: 'YELLOW', ev3dev2: 'COLOR_YELLOW' },
  '#B30006': { pybricks: 'RED', ev3dev2: 'COLOR_RED' },
  '#FFFFFF': { pybricks: 'WHITE', ev3dev2: 'COLOR_WHITE' },
  '#532115': { pybricks: 'BROWN', ev3dev2: 'COLOR_BROWN' },
  '#585858': { pybricks: 'NONE', ev3dev2: 'COLOR_NOCOLOR' },
}

const dotted = colours.map(({ value }) => ({ value, dot: value }))

/** A colour, or the nearest that the sensor tells apart. */
export const colourNames = (colour: string): Named =>
  names[colour.toUpperCase()] ?? names[nearestOption(dotted, colour)?.value ?? '#585858']!

/** What each is called on the display. */
export const shownAs: readonly (readonly [colour: string, shown: string])[] = colours.map(
  ({ value, name }) => [value, name],
)

/** What the sensor of SPIKE Prime is told to tell apart, in the words of Pybricks. */
export const sensedColours: readonly string[] = Object.values(names).map(({ pybricks }) => pybricks)
