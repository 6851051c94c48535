import type { Block, Template } from './types.ts'

function mapValues<A, B>(record: { readonly [name: string]: A }, change: (value: A) => B) {
  return Object.fromEntries(Object.entries(record).map(([name, value]) => [name, change(value)]))
}

/** A block made from a template. `freshId` is asked once a block, outer before inner. */
export function blockFrom(template: Template, freshId: () => string): Block {
  const { values, statements, ...own } = template
  return {
    id: freshId(),
    ...own,
    ...(values && { values: mapValues(values, (child) => blockFrom(child, freshId)) }),
    ...(statements && {
      statements: mapValues(statements, (rows) => rows.map((child) => blockFrom(child, freshId))),
    }),
  }
}

/** An example's blocks as stacks: each function stands alone, the others follow each other. */
export function stacksOf(example: readonly Template[]): readonly (readonly Template[])[] {
  const alone = (template: Template) => /^robProcedures_def/.test(template.type)
  return [example.filter((template) => !alone(template)), ...example.filter(alone).map((block) => [block])]
}
