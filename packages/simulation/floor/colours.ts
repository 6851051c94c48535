import type { Colour } from '../types.ts'

/** The eight colours a sensor can name, as Open Roberta writes them. */
export const COLOURS = {
  black: '#000000',
  red: '#B30006',
  yellow: '#F7D117',
  brown: '#532115',
  white: '#FFFFFF',
  green: '#00642E',
  blue: '#0057A6',
  grey: '#585858',
} as const satisfies { readonly [name: string]: Colour }

/**
 * The name of a colour, first match in this order (Open Roberta's rules; grey is ours). r, g, b 0..255;
 * hue 0..360, saturation and value 0..100. null: none of the eight.
 */
export function colourOf(r: number, g: number, b: number): Colour | null {
  const [h, s, v] = hsv(r, g, b)
  if (v <= 10) return COLOURS.black
  if ((h < 10 || h > 350) && s > 90 && v > 50) return COLOURS.red
  if (h > 40 && h < 70 && s > 90 && v > 50) return COLOURS.yellow
  if (h < 50 && s > 50 && s < 100 && v < 50) return COLOURS.brown
  if (s < 10 && v > 90) return COLOURS.white
  if (h > 70 && h < 160 && s > 80) return COLOURS.green
  if (h > 200 && h < 250 && s > 90 && v > 50) return COLOURS.blue
  if (s < 10) return COLOURS.grey
  return null
}

function hsv(r: number, g: number, b: number): readonly [hue: number, saturation: number, value: number] {
  const most = Math.max(r, g, b)
  const range = most - Math.min(r, g, b)
  const saturation = most === 0 ? 0 : (range / most) * 100
  return [hueOf(r, g, b, most, range), saturation, (most / 255) * 100]
}

/** The product first: so a hue that is a whole number comes out as one, and limits are where the rules have them. */
function hueOf(r: number, g: number, b: number, most: number, range: number): number {
  if (range === 0) return 0
  if (most === r) return (60 * (g - b)) / range + (g < b ? 360 : 0)
  if (most === g) return (60 * (b - r)) / range + 120
  return (60 * (r - g)) / range + 240
}
