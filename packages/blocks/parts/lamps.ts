import type { LedColour } from '@botgarten/simulation'
import type { Next, Robot } from '../types.ts'
import { done, fail } from './next.ts'

const lamps: ReadonlyMap<string, LedColour> = new Map([
  ['GREEN', 'green'],
  ['ORANGE', 'orange'],
  ['RED', 'red'],
])

/** Open Roberta's words for a colour and for how it lights: ON, FLASH, DOUBLE_FLASH. */
export function lampOn(robot: Robot, colour: string, mode: string): Next {
  const lamp = lamps.get(colour)
  if (lamp === undefined) return fail('unknownChoice')
  if (mode === 'ON') robot.led(lamp)
  else robot.led(lamp, mode === 'FLASH' ? 'flash' : 'double')
  return done
}
