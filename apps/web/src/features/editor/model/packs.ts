import maps from 'content:maps'
import {
  addBlocks,
  definitions,
  knowMaps,
  optionFor,
  packOf,
  type Block,
  type Definition,
  type FieldLook,
} from '@botgarten/blocks'
import type { Brain } from '@botgarten/learning/neural-network'
import { holesOf, statementNames, type Project } from '@botgarten/programs'
import { learning, learningToolbox } from '@botgarten/blocks/packs/learning'
import { fetchWords, withWords } from '#words/message.ts'

type Expert = Pick<typeof import('../view/expert/expert.ts'), 'toolboxOf' | 'everything'>

/** Words of the blocks for deeper networks, for maps and groups. */
const ofPacks = ['blocks-network', 'blocks-q-learning', 'blocks-sorting'] as const

// Maps are content, which the language does not know.
knowMaps(maps)

let expert: Expert | null = null
/** As it is before more is brought. */
const plain: { readonly [type: string]: Definition | undefined } = { ...definitions }

/** What the editor knows of the whole language; null before it was brought. */
export const expertParts = (): Expert | null => expert

/** Brings the whole language with its words; programs may hold all of it from then on. */
export async function loadExpert(): Promise<Expert> {
  const { learn, toolboxOf, everything } = await withWords(import('../view/expert/expert.ts'), [
    'expert',
    ...ofPacks,
  ])
  if (!expert) learn()
  return (expert = { toolboxOf, everything })
}

/** Brings the blocks for deeper networks, for maps and groups. */
export async function loadLearning(): Promise<void> {
  await fetchWords(...ofPacks)
  addBlocks(learning, learningToolbox)
}

/** Brings what a project's programs and brains hold and is not there yet. Returns whether its programs hold more than the plain language. */
export async function loadFor({ programs, brains }: Pick<Project, 'programs' | 'brains'>): Promise<boolean> {
  const rows = Object.values(programs).flatMap(({ stacks }) => stacks.flatMap(({ blocks }) => blocks))
  if (rows.some(learns) || Object.values(brains).some(bends)) await loadLearning()
  const more = rows.some(isMore)
  if (more && !expert) await loadExpert()
  return more
}

const inside = ({ values = {}, statements = {} }: Block): readonly Block[] => [
  ...Object.values(values),
  ...Object.values(statements).flat(),
]

/** Is there a neuron that does more than hand on its sum? */
const bends = ({ layers }: Brain): boolean =>
  layers.flat().some(({ activation }) => activation !== 'identity')

const learns = (block: Block): boolean => packOf(block.type) === 'learning' || inside(block).some(learns)

/** Is it, or does it hold, more than the plain language? */
const isMore = (block: Block): boolean =>
  !(packOf(block.type) === 'learning' || isKnown(block)) || inside(block).some(isMore)

function isKnown(block: Block): boolean {
  const definition = plain[block.type]
  if (!definition) return false
  const { look } = definition
  const holes = holesOf(block, definition).map(({ input }) => input)
  const rows = statementNames(block, look)
  return (
    !block.mutation?.attrs.elseif &&
    !block.statements?.ST &&
    look.fields.every((field) => isPlain(field, block.fields?.[field.name])) &&
    Object.keys(block.values ?? {}).every((name) => holes.includes(name)) &&
    Object.keys(block.statements ?? {}).every((name) => rows.includes(name))
  )
}

/** Does the plain look of the block know this value of a field? */
function isPlain(field: FieldLook, value: string | undefined): boolean {
  if (value === undefined) return true
  if (field.kind === 'hidden') return field.name !== 'MODE' || value === field.preset
  return field.kind !== 'choice' || optionFor(field.options, value) !== undefined
}
