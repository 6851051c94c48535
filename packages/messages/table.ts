import type { Message } from './message.ts'

/** A file of messages. */
export type Tree = { readonly [key: string]: Message | Tree }
/** Messages by their whole keys: `world.lost`. */
export type Table = { readonly [key: string]: Message }

export const flat = (tree: Tree, before = ''): Table =>
  Object.fromEntries(
    Object.entries(tree).flatMap(([key, node]) => {
      if (key === '$schema') return []
      return isMessage(node) ? [[before + key, node]] : Object.entries(flat(node, `${before}${key}.`))
    }),
  )

const isMessage = (node: Message | Tree): node is Message => typeof node === 'string' || Array.isArray(node)
