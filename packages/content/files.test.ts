import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { basename, join } from 'node:path'
import { afterAll, expect, test } from 'vitest'
import { content, contentIn } from './files.ts'

const folders: string[] = []
afterAll(() => folders.forEach((folder) => rmSync(folder, { recursive: true })))

/** A content/ with one card, one world and the words of two languages, to be changed. */
function small() {
  const root = mkdtempSync(join(tmpdir(), 'botgarten-content-'))
  folders.push(root)
  for (const path of ['cards/network/05-friendship', 'worlds/friendship', 'words'])
    cpSync(content.path(path), join(root, path), { recursive: true })
  return root
}

test('a new card is a new folder: it stands in the list where its number says, in the bed of the folder above', () => {
  const root = small()
  const folder = join(root, 'cards/network/04-alone')
  cpSync(join(root, 'cards/network/05-friendship'), folder, { recursive: true })
  const file = join(folder, 'card.json')
  writeFileSync(file, readFileSync(file, 'utf8').replace('"id": "friendship"', '"id": "alone"'))
  writeFileSync(join(folder, 'en.md'), readFileSync(join(folder, 'en.md'), 'utf8').replace(/^.*/, '# Alone'))
  const { cards, card } = contentIn(root)
  expect(cards.map(({ id, bed }) => [id, bed])).toEqual([
    ['alone', 'network'],
    ['friendship', 'network'],
  ])
  expect(cards[0]!.title).toEqual({ de: 'Freundschaft', en: 'Alone' })
  expect(card('alone')!.world).toEqual(content.world('friendship'))
})

test('a card that is not called like its folder is named', () => {
  const root = small()
  cpSync(join(root, 'cards/network/05-friendship'), join(root, 'cards/network/06-twin'), { recursive: true })
  expect(() => contentIn(root).cards).toThrow(/06-twin.*"friendship"/)
})

test('a folder of cards that is no playground is named', () => {
  const root = small()
  cpSync(join(root, 'cards/network'), join(root, 'cards/cooking'), { recursive: true })
  rmSync(join(root, 'cards/network'), { recursive: true })
  expect(() => contentIn(root).cards).toThrow('cooking')
})

test('what is not there is null, also where its name leads out of the folder', () => {
  expect(content.card('../cards')).toBeNull()
  expect(content.program('friendship', 'wrong/nothing')).toBeNull()
  expect(content.world('..')).toBeNull()
  expect(content.map('../maps/city')).toBeNull()
  expect(content.mapFile('moon')).toBeNull()
})

test('every list is in the order of its folders', () => {
  const numbers = content.items.map(({ kind, number }) => `${kind} ${String(number).padStart(2, '0')}`)
  expect(numbers).toEqual(numbers.toSorted())
  expect(content.cards.map(({ id }) => basename(content.cardFolder(id)).slice(3))).toEqual(
    content.cards.map(({ id }) => id),
  )
  expect(content.sets.map(({ id }) => id)).toEqual(['vessels', 'leaves', 'buttons'])
})
