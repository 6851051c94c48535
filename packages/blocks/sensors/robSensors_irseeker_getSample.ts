import { missing } from '../parts/python.ts'
import { show, start } from '../parts/examples.ts'
import { choice, sensorPort, worded } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import { reading, sample } from '../parts/samples.ts'
import type { Definition } from '../types.ts'

const type = 'robSensors_irseeker_getSample'

/** Direction of an infrared light, 1 to 9, 5 straight ahead; 0: there is none. In our worlds there is none. */
export const robSensors_irseeker_getSample: Definition = {
  pack: 'expert',
  ...sample(
    type,
    choice('MODE', [worded('MODULATED', 'modulated'), worded('UNMODULATED', 'unmodulated')]),
    sensorPort('1'),
  ),
  run: () => give(0),
  python: missing('irseeker'),
  example: [start, show(reading(type, 'MODULATED', '1'))],
}
