import { start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, rows, worded, words } from '../parts/looks.ts'
import { numberIn } from '../parts/numbers.ts'
import { waiting } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'mbedActions_play_note'

/** Equal temperament, a' = 440 Hz; as many places as Open Roberta writes. */
const notes = [
  ['130.813', 'c3'],
  ['138.591', 'cis3'],
  ['146.832', 'd3'],
  ['155.563', 'dis3'],
  ['164.814', 'e3'],
  ['174.614', 'f3'],
  ['184.997', 'fis3'],
  ['195.998', 'g3'],
  ['207.652', 'gis3'],
  ['220', 'a3'],
  ['233.082', 'ais3'],
  ['246.942', 'b3'],
  ['261.626', 'c4'],
  ['277.183', 'cis4'],
  ['293.665', 'd4'],
  ['311.127', 'dis4'],
  ['329.628', 'e4'],
  ['349.228', 'f4'],
  ['369.994', 'fis4'],
  ['391.995', 'g4'],
  ['415.305', 'gis4'],
  ['440', 'a4'],
  ['466.164', 'ais4'],
  ['493.883', 'b4'],
  ['523.251', 'c5'],
  ['554.365', 'cis5'],
  ['587.330', 'd5'],
  ['622.254', 'dis5'],
  ['659.255', 'e5'],
  ['698.456', 'f5'],
  ['739.989', 'fis5'],
  ['783.991', 'g5'],
  ['830.609', 'gis5'],
  ['880', 'a5'],
  ['932.328', 'ais5'],
  ['987.767', 'b5'],
] as const

/** DURATION in ms: 2000 is a whole note. FREQUENCE in Hz as Open Roberta writes it; other numbers of a file play, too. */
export const mbedActions_play_note: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [
      choice('DURATION', [
        worded('2000', 'whole'),
        worded('1000', 'half'),
        worded('500', 'quarter'),
        worded('250', 'eighth'),
        worded('125', 'sixteenth'),
      ]),
      choice(
        'FREQUENCE',
        notes.map(([frequency, words]) => worded(frequency, words)),
        '261.626',
      ),
    ],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  uses: 'sound',
  run(block, frame, context) {
    const milliseconds = numberIn(field(block, 'DURATION', '2000')) ?? 0
    const frequency = numberIn(field(block, 'FREQUENCE', '261.626')) ?? 0
    if (frame.counter === undefined && milliseconds > 0) context.robot.tone(frequency, milliseconds / 1000)
    return waiting(frame, context, milliseconds)
  },
  python: (py) => py.line(py.robot.tone(py.field('FREQUENCE', '261.626'), py.field('DURATION', '2000'))),
  example: [start, { type, fields: { DURATION: '250', FREQUENCE: '261.626' } }],
}
