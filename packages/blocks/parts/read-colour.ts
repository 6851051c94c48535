import type { SensorPort } from '@botgarten/simulation'
import type { Expression, PythonAt } from '../python.ts'
import { readIn } from './python.ts'
import type { Definition, Robot, Value } from '../types.ts'
import { field, sensorPortIn } from './fields.ts'
import { fail, give } from './next.ts'

function rgbAt(robot: Robot, port: SensorPort): Value {
  const channels = (['red', 'green', 'blue'] as const).map((mode) => robot.read(port, mode))
  return channels.includes(null) ? null : channels
}

/**
 * MODE COLOUR: one of the eight colours as `#RRGGBB` · RGB: a list of three, 0..255 · others: brightness of the floor,
 * 0..100 (no world of ours is dark, so that light from around is what comes back).
 */
export const readColour: Definition['run'] = (block, _frame, { robot }) => {
  const port = sensorPortIn(block, 'SENSORPORT')
  const mode = field(block, 'MODE', 'COLOUR')
  if (port === undefined) return fail('nothingToRead')
  const reading =
    mode === 'RGB' ? rgbAt(robot, port) : robot.read(port, mode === 'COLOUR' ? 'colour' : 'light')
  return reading === null ? fail('nothingToRead') : give(reading)
}

const whats: ReadonlyMap<string, string> = new Map([
  ['COLOUR', 'colour'],
  ['RGB', 'rgb255'],
  ['AMBIENTLIGHT', 'ambient'],
])

/** Other modes read the light that comes back. */
export const pythonColour = (py: PythonAt): Expression =>
  readIn(py, 'colour', whats.get(py.field('MODE', 'COLOUR')) ?? 'light')
