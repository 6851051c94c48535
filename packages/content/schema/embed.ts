import * as v from 'valibot'

const id = v.pipe(v.string(), v.regex(/^[a-z0-9][a-z0-9-]*$/))
/** Id of a block in a card's program. */
const block = v.pipe(v.string(), v.regex(/^\w[\w-]*$/))
const count = v.pipe(v.string(), v.regex(/^\d+$/), v.transform(Number))
const roads = v.pipe(
  v.string(),
  v.regex(/^\d+-\d+(,\d+-\d+)*$/),
  v.transform((text) => text.split(',')),
)
const ids = v.pipe(
  v.string(),
  v.regex(/^[a-z0-9-]+(,[a-z0-9-]+)*$/),
  v.transform((text) => text.split(',')),
)
/** A program of a card's folder, without `.json`. */
const named = v.pipe(v.string(), v.regex(/^(start|solution|wrong\/[a-z0-9-]+)$/))
const file = v.optional(named, 'start')

/**
 * What stands in a text as `::kind{name=value}` and is drawn by the lab's own renderers from the file it names.
 * Nothing here repeats a number of that file: what a sheet shows is what the lab runs.
 */
const embed = v.variant('kind', [
  /** A side of a card. */
  v.strictObject({ kind: v.literal('card'), id, side: v.picklist(['front', 'back']) }),
  /** The network of a card's program, with its weights. */
  v.strictObject({ kind: v.literal('net'), card: id, file }),
  /** The weights of that network as a table; `from`: those of another program before them, where they differ. */
  v.strictObject({ kind: v.literal('knobs'), card: id, file, from: v.exactOptional(named) }),
  /** What a card's learner knows after so many tries, as a table (`answers.json`). */
  v.strictObject({ kind: v.literal('tries'), card: id }),
  /** A card's program as blocks, or a part of it: the block `only`, the block `fold` on one line (their ids). */
  v.strictObject({
    ...{ kind: v.literal('program'), card: id, file },
    ...{ only: v.optional(block), fold: v.optional(block) },
  }),
  /** The robot of a card: as it greets, or from above, large, with the names of its parts. */
  v.strictObject({ kind: v.literal('robot'), card: id, view: v.picklist(['front', 'above']) }),
  /** One block as it lies in the toolbox. */
  v.strictObject({ kind: v.literal('block'), type: v.string() }),
  /** A map, with its task where one is named; a closed road is closed in the direction that is written. */
  v.strictObject({
    ...{ kind: v.literal('map'), id },
    ...{ start: v.optional(count), goal: v.optional(count), closed: v.optional(roads) },
  }),
  /** The way that a card's solution learns. */
  v.strictObject({ kind: v.literal('way'), card: id }),
  /** A card's world with its robot on start pose `start`, from 0. */
  v.strictObject({ kind: v.literal('scene'), card: id, start: v.optional(count, '0') }),
  v.strictObject({ kind: v.literal('world'), id }),
  /** The lab itself with a card in it, to be worked with. On paper: its scene. */
  v.strictObject({ kind: v.literal('live'), card: id, file }),
  /** The Sorting Playground with a set. On paper: its things. */
  v.strictObject({ kind: v.literal('sort'), set: id }),
  /** Things of a set; `cut`: on small cards with lines to cut along. */
  v.strictObject({ kind: v.literal('things'), set: id, cut: v.optional(v.picklist(['yes', 'no']), 'no') }),
  /** A code to photograph that opens `card:<id>` or `item:<id>` at the address where this lab lives. */
  v.strictObject({ kind: v.literal('qr'), to: v.pipe(v.string(), v.regex(/^(card|item):[a-z0-9-]+$/)) }),
  /** One round of a way of learning as a flow diagram. */
  v.strictObject({ kind: v.literal('flow'), id: v.picklist(['q-learning']) }),
  /** The table of trials: empty, or its first row filled from a real one. */
  v.strictObject({
    ...{ kind: v.literal('trials'), card: id, rows: count },
    filled: v.optional(v.picklist(['yes', 'no']), 'no'),
  }),
  /** Who wrote on it, of which class and when; `pair`: with whom. */
  v.strictObject({ kind: v.literal('name'), pair: v.optional(v.picklist(['yes', 'no']), 'no') }),
  /** Lines to write on. */
  v.strictObject({ kind: v.literal('lines'), count }),
  /** A field to draw in, cm high. */
  v.strictObject({ kind: v.literal('field'), cm: count }),
  /** The sheet goes on on its next side. */
  v.strictObject({ kind: v.literal('page') }),
  /** A clock that says when to swap. On paper: its minutes. */
  v.strictObject({ kind: v.literal('timer'), minutes: count }),
  /** What will Bo do? Questions of a module: all of them, or those that `only` names; `answers`: with what happens, and why. */
  v.strictObject({
    ...{ kind: v.literal('questions'), module: count, only: v.optional(ids) },
    answers: v.exactOptional(v.literal('yes')),
  }),
  /** What modules and cards cover of the frameworks. */
  v.strictObject({ kind: v.literal('alignment') }),
  /** All cages of the zoo as a table: to be filled in, or with what value iteration says of each. */
  v.strictObject({ kind: v.literal('cages'), filled: v.optional(v.picklist(['yes', 'no']), 'no') }),
  /** Cages of the zoo of sensors: a table to be filled in, its answers, a poster of the animals (all, or those of `only`), or its back. */
  v.strictObject({
    ...{ kind: v.literal('senses'), show: v.picklist(['sheet', 'answers', 'poster', 'back']) },
    only: v.optional(ids),
  }),
  /** The race of brains on a course, to be worked with. On paper: the course. */
  v.strictObject({ kind: v.literal('race'), course: id }),
  /** What others made and materials lead to, with its licence and where that was looked up. */
  v.strictObject({ kind: v.literal('references') }),
])

export type Embed = v.InferOutput<typeof embed>

/** Reads `::kind{name=value name=value}`. @throws SyntaxError that says what is wrong with which one. */
export function readEmbed(line: string): Embed {
  const [, kind, inside = ''] = /^::([a-z]+)(?:\{([^{}]*)\})?$/.exec(line.trim()) ?? []
  if (!kind) throw new SyntaxError(`"${line}" must be "::kind{name=value}".`)
  const pairs = inside.split(' ').filter((pair) => pair !== '')
  const values = pairs.map((pair) => /^([a-z]+)=(\S+)$/.exec(pair)?.slice(1))
  const wrong = pairs.find((_, index) => !values[index])
  if (wrong) throw new SyntaxError(`"${line}": "${wrong}" must be "name=value".`)
  const read = v.safeParse(embed, { ...Object.fromEntries(values as string[][]), kind })
  if (!read.success) throw new SyntaxError(`"${line}": ${v.summarize(read.issues)}`)
  return read.output
}
