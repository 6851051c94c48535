import type { RobotKey } from '@botgarten/simulation'
import { forever, lampIf, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, hidden, worded } from '../parts/looks.ts'
import { fail, give } from '../parts/next.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_key_getSample'

const keys: ReadonlyMap<string, RobotKey | 'any'> = new Map([
  ['ENTER', 'enter'],
  ['UP', 'up'],
  ['DOWN', 'down'],
  ['LEFT', 'left'],
  ['RIGHT', 'right'],
  ['ESCAPE', 'escape'],
  ['ANY', 'any'],
])

/** Is this key of the robot's panel pressed? */
export const robSensors_key_getSample: Definition = {
  pack: 'core',
  ...sample(
    type,
    hidden('MODE', 'PRESSED'),
    choice('SENSORPORT', [
      worded('ENTER', 'keyEnter'),
      worded('UP', 'keyUp'),
      worded('DOWN', 'keyDown'),
      worded('LEFT', 'keyLeft'),
      worded('RIGHT', 'keyRight'),
      worded('ESCAPE', 'keyEscape'),
      worded('ANY', 'keyAny'),
    ]),
    'Boolean',
  ),
  run(block, _frame, { robot }) {
    const key = keys.get(field(block, 'SENSORPORT', 'ENTER'))
    return key === undefined ? fail('unknownChoice') : give(robot.key(key))
  },
  python: (py) =>
    py.robot.key(keys.get(py.field('SENSORPORT', 'ENTER')) ?? py.gap('problem.unknownChoice')) ??
    py.missing('key'),
  example: [start, forever(lampIf(reading(type, 'PRESSED', 'ENTER')))],
}
