import { definitions, isBlockType, type Block, type FieldLook } from '@botgarten/blocks'
import { holesOf, statementNames, type Program } from '@botgarten/programs'
import { fetchExpertWords } from '#lib/words/say.ts'

type Expert = Pick<typeof import('./expert/later.ts'), 'expertShelf'>

let expert: Expert | null = null

/** What the editor knows of the whole language; null before it was brought. */
export const expertParts = (): Expert | null => expert

/** Brings the whole language with its words; programs may hold all of it from then on. */
export async function bringExpert(): Promise<Expert> {
  const [{ learn, expertShelf }] = await Promise.all([import('./expert/later.ts'), fetchExpertWords()])
  if (!expert) learn()
  return (expert = { expertShelf })
}

/** Brings the whole language where these programs hold more than the cards need. */
export async function bringFor(programs: { readonly [id: string]: Program }): Promise<void> {
  const rows = Object.values(programs).flatMap(({ stacks }) => stacks.flatMap(({ blocks }) => blocks))
  if (!expert && rows.some(isMore)) await bringExpert()
}

/** Is it, or does it hold, more of the language than is loaded? */
function isMore(block: Block): boolean {
  const values = Object.values(block.values ?? {})
  const statements = Object.values(block.statements ?? {}).flat()
  return !isKnown(block) || values.some(isMore) || statements.some(isMore)
}

function isKnown(block: Block): boolean {
  if (!isBlockType(block.type)) return false
  const definition = definitions[block.type]
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
  const same = (option: { readonly value: string }) => option.value.toUpperCase() === value.toUpperCase()
  return field.kind !== 'choice' || field.options.some(same)
}
