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
