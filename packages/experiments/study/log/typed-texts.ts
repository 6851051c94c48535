import { definitions, isBlockType, type Block, type FieldLook } from '@botgarten/blocks'
import type { Document, TrainingChange } from '@botgarten/lab'
import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { Program } from '@botgarten/programs'
import type { World } from '@botgarten/simulation'

const letters = 'abcdefghijklmnopqrstuvwxyz'

/** The `count`-th word of so many letters; where there are no more of this length they begin again. */
function wordOf(length: number, count: number): string {
  let rest = count
  const word = Array.from({ length }, () => {
    const letter = letters[rest % letters.length]!
    rest = Math.floor(rest / letters.length)
    return letter
  })
  return word.join('')
}

/**
 * Leaves out of programs, worlds and brains what a child has typed, and every picture of its own. The same text is the same
 * word everywhere, of the same length: names still find each other, and what is spoken takes as long.
 */
export class TypedTexts {
  readonly #words = new Map<string, string>()
  readonly #counts = new Map<number, number>()

  /** The word for a text. */
  hide(text: string): string {
    const known = this.#words.get(text)
    if (known !== undefined) return known
    const count = this.#counts.get(text.length) ?? 0
    const word = wordOf(text.length, count)
    this.#counts.set(text.length, count + 1)
    this.#words.set(text, word)
    return word
  }

  document({ programs, world, brains, tables }: Document): { document: Document; photo: boolean } {
    const photo = 'asset' in world.floor && !world.floor.asset.startsWith('content:')
    return {
      document: {
        programs: this.programs(programs),
        world: this.#world(photo ? { ...world, floor: { colour: '#FFFFFF' } } : world),
        brains: Object.fromEntries(Object.entries(brains).map(([id, brain]) => [id, this.brain(brain)])),
        ...(tables && { tables }),
      },
      photo,
    }
  }

  programs(programs: Document['programs']): Document['programs'] {
    return Object.fromEntries(Object.entries(programs).map(([id, program]) => [id, this.#program(program)]))
  }

  brain(brain: Brain): Brain {
    const { sets, examples, practice, ...rest } = brain
    return {
      ...rest,
      sets: Object.fromEntries(Object.entries(sets).map(([name, weights]) => [this.hide(name), weights])),
      ...this.training({ ...(examples && { examples }), ...(practice && { practice }) }),
    } as Brain
  }

  training({ examples, practice }: TrainingChange): TrainingChange {
    const drives = examples?.drives.map(({ note: _, ...drive }) => drive)
    return { ...(examples && drives && { examples: { ...examples, drives } }), ...(practice && { practice }) }
  }

  #world(world: World): World {
    return { ...world, robots: world.robots.map((robot) => ({ ...robot, brain: this.hide(robot.brain) })) }
  }

  #program({ stacks }: Program): Program {
    const shown = stacks.map(({ x, y, blocks }) => ({ x, y, blocks: blocks.map((one) => this.#block(one)) }))
    return { stacks: shown, config: { stacks: [] } }
  }

  #block(block: Block): Block {
    const { id, type, fields, mutation, values, statements, disabled, shadow, data } = block
    return {
      ...{ id, type },
      ...(fields && { fields: this.#fields(type, fields) }),
      ...(mutation && { mutation: this.#mutation(mutation) }),
      ...(values && { values: mapped(values, (one) => this.#block(one)) }),
      ...(statements && { statements: mapped(statements, (rows) => rows.map((one) => this.#block(one))) }),
      ...(disabled !== undefined && { disabled }),
      // That there is a network in it decides which brain runs; the brain is in the log.
      ...(data?.startsWith('{') && { data: '{}' }),
      ...(shadow !== undefined && { shadow }),
    }
  }

  #fields(type: string, fields: NonNullable<Block['fields']>): NonNullable<Block['fields']> {
    const looks = isBlockType(type) ? definitions[type].look.fields : []
    return Object.fromEntries(
      Object.entries(fields).map(([name, value]) => {
        const look = looks.find((one) => one.name === name)
        return [name, look && isNotTyped(look, value) ? value : this.hide(value)]
      }),
    )
  }

  /** Of a function that is called it holds the names. */
  #mutation({ attrs, args }: NonNullable<Block['mutation']>): NonNullable<Block['mutation']> {
    return {
      attrs: Object.fromEntries(
        Object.entries(attrs).map(([key, value]) => [key, key === 'name' ? this.hide(value) : value]),
      ),
      ...(args && { args: args.map(({ name, type }) => ({ name: this.hide(name), type })) }),
    }
  }
}

const mapped = <From, To>(record: { readonly [name: string]: From }, change: (one: From) => To) =>
  Object.fromEntries(Object.entries(record).map(([name, one]) => [name, change(one)]))

const isNumber = (value: string) => value.trim() !== '' && Number.isFinite(Number(value))

/** Was this chosen or counted, and not typed? What is never on the block no child has typed. */
function isNotTyped(look: FieldLook, value: string): boolean {
  if (look.kind === 'hidden') return true
  if (look.kind === 'number') return isNumber(value)
  if (look.kind !== 'choice') return false
  // A map that is not among those to choose from is one all the same.
  return (
    isNumber(value) || /^own:|^MAP_[A-Z0-9_]+$/.test(value) || look.options.some((one) => one.value === value)
  )
}
