import type { Nodes } from 'mdast'
import type { ItemNode } from './itemTypes.ts'

/** What all our markdown may hold, with what `inside` makes of its children. */
export type Plain<Child> =
  | { readonly type: 'text'; readonly value: string }
  | {
      readonly type: 'paragraph' | 'strong' | 'emphasis' | 'listItem'
      readonly children: readonly Child[]
    }
  | { readonly type: 'list'; readonly ordered: boolean; readonly children: readonly Child[] }

/** A node that all our markdown may hold; null: it is another one. */
export function plainNode<Child>(
  node: Nodes,
  inside: (node: Nodes) => Child | readonly Child[],
): Plain<Child> | null {
  switch (node.type) {
    case 'text':
      return { type: 'text', value: node.value }
    case 'strong':
    case 'emphasis':
    case 'paragraph':
    case 'listItem':
      return { type: node.type, children: childrenOf(node).flatMap(inside) }
    case 'list':
      return { type: 'list', ordered: node.ordered ?? false, children: node.children.flatMap(inside) }
    default:
      return null
  }
}

/** Nodes inside a node; none for one that holds none. */
export const childrenOf = (node: Nodes): readonly Nodes[] => ('children' in node ? node.children : [])

/** The words of a node alone. */
export const plainOf = (node: Nodes | ItemNode): string =>
  'value' in node
    ? node.value
    : 'children' in node
      ? (node.children as readonly (Nodes | ItemNode)[]).map(plainOf).join('')
      : ''
