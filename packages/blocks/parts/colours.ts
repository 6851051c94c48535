import type { Colour } from '@botgarten/simulation'
import { choice, worded } from './looks.ts'

/** The eight colours of Open Roberta's colour sensor: value, key in the section `choice`, name on the robot's display. */
export const colours: readonly { readonly value: Colour; readonly words: string; readonly name: string }[] = [
  { value: '#000000', words: 'black', name: 'BLACK' },
  { value: '#0057A6', words: 'blue', name: 'BLUE' },
  { value: '#00642E', words: 'green', name: 'GREEN' },
  { value: '#F7D117', words: 'yellow', name: 'YELLOW' },
  { value: '#B30006', words: 'red', name: 'RED' },
  { value: '#FFFFFF', words: 'white', name: 'WHITE' },
  { value: '#532115', words: 'brown', name: 'BROWN' },
  { value: '#585858', words: 'grey', name: 'GREY' },
]

export const colourField = (preset: Colour) =>
  choice(
    'COLOUR',
    colours.map(({ value, words }) => worded(value, words, value)),
    preset,
  )

/** Is the text `#RRGGBB`, in either case? */
export const isColour = (value: unknown): value is Colour =>
  typeof value === 'string' && /^#[0-9a-f]{6}$/i.test(value)
