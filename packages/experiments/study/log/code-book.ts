import type * as v from 'valibot'
import type { Kind, kinds } from './kinds.ts'

/** What a field holds, and what that means. */
type FieldNote = readonly [kind: Kind, meaning: string]

interface EventNote {
  readonly meaning: string
  readonly fields: { readonly [name: string]: FieldNote }
}

/** Of the log as a file; a file with another number is not read. */
export const format = 1

/** Fields of every line, before those of its event. */
export const everyLine = {
  t: ['whole', 'Milliseconds since the session began; pauses of the log count.'],
  session: ['name', 'One sitting of one child: `s` and eight hexadecimal digits by chance.'],
  pseudonym: [
    'pseudonym',
    'The child: two digits of its group, two of its own, a letter that guards against slips.',
  ],
} as const satisfies { readonly [name: string]: FieldNote }

/** Every event of a log: the file's format is this table, and nothing else. */
export const codeBook = {
  session: {
    meaning: 'The child has said yes; first line of a session.',
    fields: {
      format: ['whole', 'Format of the file: 1.'],
      version: ['name', 'Version of Botgarten that wrote it.'],
      study: ['name', 'Id of the study.'],
      group: ['whole', 'Number of the group, from 1.'],
      seed: ['seed', 'Seed of the study, from which the order was drawn.'],
      order: ['names', 'Modules in the order of this group.'],
    },
  },
  part: { meaning: 'The child goes on to a module.', fields: { module: ['name', 'Id of the module.'] } },
  open: {
    meaning: 'A lab is opened, or the log goes on after a pause: everything stands at its start.',
    fields: {
      place: ['name', 'Id of the card; `free`: the free lab.'],
      seed: ['seed', 'Seed of its runs.'],
      photo: ['yes', 'Was a picture of its own left out of the floor?'],
      document: ['document', 'Programs, world and brains, without typed texts.'],
    },
  },
  edit: {
    meaning: 'Blocks were changed.',
    fields: {
      programs: ['programs', 'The programs that are different now, whole.'],
      fromStart: ['yes', 'Does the robot go back to its start?'],
    },
  },
  knob: {
    meaning: 'A weight was set. A pull is many of these.',
    fields: {
      brain: ['name', 'Id of the network.'],
      from: ['name', 'Id of the neuron where the link begins.'],
      to: ['name', 'Id of the neuron where it ends.'],
      weight: ['number', 'The new weight.'],
      set: ['name', 'Set of weights; empty: the knobs.'],
    },
  },
  run: { meaning: 'Start was pressed.', fields: { seed: ['seed', 'Seed of the run.'] } },
  time: {
    meaning: 'Simulated time went by, up to this moment.',
    fields: {
      ticks: ['whole', 'Sixtieths of a second.'],
      practising: ['yes', 'Was practice that the program asked for still under way after it?'],
    },
  },
  end: {
    meaning: 'A run is over: it ended, was stopped, or others blocks began another one.',
    fields: {
      ticks: ['whole', 'How long it ran, in sixtieths of a second.'],
      hash: ['hash', '64 bits over the poses of all robots at every tick.'],
      passed: ['names', 'Ids of the checks that were green.'],
    },
  },
  check: {
    meaning: 'A check of the card turned green or open again.',
    fields: {
      check: ['name', 'Id of the check.'],
      passed: ['yes', 'Is it green?'],
      tick: ['whole', 'Sixtieths of a second since Start.'],
    },
  },
  hint: {
    meaning: 'A hint was asked for.',
    fields: { shown: ['whole', 'How many hints the child has seen.'] },
  },
  step: {
    meaning: 'A step in a playground.',
    fields: {
      step: [
        'step',
        '`network`: one run of the network · `block`, `over`: one block · `tick`: one sixtieth of a second.',
      ],
      robot: ['name', 'Id of the robot; empty: the first.'],
    },
  },
  learned: {
    meaning: 'The robot has learned by trying.',
    fields: { seed: ['seed', 'Seed of the learning.'], moves: ['whole', 'Moves so far.'] },
  },
  place: {
    meaning: 'A robot or a thing was put somewhere.',
    fields: {
      thing: ['name', 'Its id.'],
      pose: ['pose', 'cm from the bottom left, degrees.'],
      start: ['pose or nothing', 'Where it starts from then on, if elsewhere.'],
    },
  },
  key: {
    meaning: 'A key that drives the robot went down or up.',
    fields: {
      key: ['key', 'Which one.'],
      down: ['yes', 'Is it down?'],
      robot: ['name', 'Id of the robot; empty: the first.'],
    },
  },
  button: {
    meaning: 'A button on the robot went down or up.',
    fields: {
      button: ['button', 'Which one.'],
      down: ['yes', 'Is it down?'],
      robot: ['name', 'Id of the robot; empty: the first.'],
    },
  },
  pad: {
    meaning: 'A hand on the pad drives the robot, or lets go.',
    fields: {
      hand: ['hand', 'Percent of both wheels and of what else it holds; nothing: it lets go.'],
      robot: ['name', 'Id of the robot; empty: the first.'],
    },
  },
  record: {
    meaning: 'Examples are recorded from now on, or no more.',
    fields: { recording: ['recording', 'Robot, network, drive and rhythm; nothing: no more.'] },
  },
  remember: {
    meaning: 'One example was written.',
    fields: { row: ['remembered', 'Robot, network, drive and wheels.'] },
  },
  training: {
    meaning: 'What a network was shown, or how it practises, was changed.',
    fields: {
      brain: ['name', 'Id of the network.'],
      change: ['training', 'Examples and practice that are new.'],
      without: ['names', '`examples`, `practice`: there are none any more.'],
    },
  },
  brain: {
    meaning: 'A network got other weights at once: practice, undo, reset.',
    fields: { brain: ['name', 'Id of the network.'], value: ['brain', 'All of it.'] },
  },
  rebuild: {
    meaning: 'The world or the robots were changed.',
    fields: {
      document: ['document', 'Programs, world and brains of then.'],
      photo: ['yes', 'Was a picture of its own left out of the floor?'],
      floor: ['yes', 'Is the floor painted again?'],
      stood: ['poses', 'Where things are put.'],
    },
  },
  pause: { meaning: 'The run was paused.', fields: {} },
  resume: { meaning: 'The run goes on.', fields: {} },
  stop: { meaning: 'Stop was pressed.', fields: {} },
  reset: { meaning: 'Everything goes back to its start.', fields: {} },
  look: { meaning: 'A moment of the run is looked at.', fields: { tick: ['whole', 'Which one.'] } },
  branch: { meaning: 'A moment of the past becomes the present.', fields: {} },
  swap: { meaning: 'The other future takes the place of this one.', fields: {} },
  stops: {
    meaning: 'The run pauses before these blocks from now on.',
    fields: { blocks: ['names', 'Their ids.'] },
  },
  rest: { meaning: 'The child has paused the log: nothing is written until `open`.', fields: {} },
  over: { meaning: 'The child has ended the session.', fields: {} },
} as const satisfies { readonly [event: string]: EventNote }

export type EventName = keyof typeof codeBook

type Fields<Notes> = {
  readonly [Name in keyof Notes]: Notes[Name] extends readonly [infer One extends Kind, string]
    ? v.InferOutput<(typeof kinds)[One]>
    : never
}

/** What happened, without when and to whom. */
export type Entry = {
  [Name in EventName]: { readonly event: Name } & Fields<(typeof codeBook)[Name]['fields']>
}[EventName]

/** One line of a log. */
export type Line = Fields<typeof everyLine> & Entry

/** The code book as a table: an event and a field a row, the fields of every line first. */
export const codeBookRows = (): readonly (readonly string[])[] => [
  ['event', 'field', 'type', 'meaning'],
  ...Object.entries(everyLine).map(([field, [kind, meaning]]) => ['', field, kind, meaning]),
  ...Object.entries(codeBook).flatMap(([event, { meaning, fields }]) => [
    [event, '', '', meaning],
    ...Object.entries<FieldNote>(fields).map(([field, [kind, says]]) => [event, field, kind, says]),
  ]),
]
