import { basename } from 'node:path'
import { content } from '@botgarten/content/files'
import type { Item } from '@botgarten/content/items'
import { CallError } from '../errors.ts'
import { nearest } from './nearest.ts'

/** An item and its folder's name: `01-network-cards`. */
export interface FoundItem {
  readonly item: Item
  readonly folder: string
}

/** All items in the order of their folders. */
const allItems = (): readonly FoundItem[] =>
  content.items.map((item) => ({ item, folder: basename(content.itemFolder(item.id)) }))

/** The items that a call names. @throws CallError with the nearest names for what is not there */
export function itemsNamed(names: readonly string[]): readonly FoundItem[] {
  const all = allItems()
  if (names.includes('all')) return all
  return names.map((name) => {
    const found = all.find(({ item }) => item.id === name)
    if (found) return found
    const near = nearest(
      name,
      all.map(({ item }) => item.id),
    )
    throw new CallError('call.noItem', { name, near: near.join(', ') })
  })
}
