import { readdirSync } from 'node:fs'
import { basename, dirname } from 'node:path'
import type { CardHead, LoadedCard } from '../catalogue.ts'
import { newBlocks } from '../items/newBlocks.ts'
import { readBed, readCard } from '../schema/card.ts'
import { readCardText, titleOf } from '../schema/cardText.ts'
import type { Card, CardProgram, WorldFile } from '../schema/cardTypes.ts'
import { each, idOf, named, once, type Folder } from './folder.ts'

/** Worlds, and the cards that are played in them. */
export function cardsIn(content: Folder) {
  const worlds = once(() => content.foldersWith('worlds/*/world.json').map(idOf))
  const world = (id: string) =>
    worlds().includes(id) ? (content.json('worlds', id, 'world.json') as WorldFile) : null
  function worldNamed(id: string): WorldFile {
    const found = world(id)
    if (!found) throw new RangeError(`There is no world "${id}".`)
    return found
  }

  const folders = once(
    () => new Map(content.foldersWith('cards/*/*/card.json').map((one) => [idOf(one), one])),
  )
  function folderOf(id: string): string {
    const folder = folders().get(id)
    if (folder === undefined) throw new RangeError(`There is no card "${id}".`)
    return folder
  }
  const cardIn = (folder: string): Card => named(folder, readCard(content.json(folder, 'card.json')))

  const textIn = each((folder) => content.translated(folder, readCardText))
  const bedIn = (folder: string) => readBed(basename(dirname(folder)))

  function headIn(folder: string): CardHead {
    const { id, code, group, chapter, starts, world, grades, minutes } = cardIn(folder)
    const { floor } = worldNamed(world)
    return {
      ...{ id, code, grades, minutes, bed: bedIn(folder) },
      ...(group && { group }),
      ...(chapter && { chapter }),
      ...('asset' in floor && { floor: floor.asset }),
      ...{ starts: starts.length, title: content.translated(folder, titleOf) },
    }
  }

  function card(id: string): LoadedCard | null {
    if (!folders().has(id)) return null
    const folder = folderOf(id)
    const card = cardIn(folder)
    return {
      card,
      bed: bedIn(folder),
      world: worldNamed(card.world),
      start: content.json(folder, 'start.json') as CardProgram,
      text: textIn(folder),
    }
  }

  function program(id: string, file: string): CardProgram | null {
    const isThere = folders().has(id) && content.has(folderOf(id), `${file}.json`)
    return isThere ? (content.json(folderOf(id), `${file}.json`) as CardProgram) : null
  }

  return {
    ...{ worlds, world, card, program, folderOf },
    heads: once(() => [...folders().values()].map(headIn)),
    goals: () =>
      Object.fromEntries(
        [...folders()].map(([id, folder]) => [
          id,
          content.translated(folder, (text) => readCardText(text).goal.sentence),
        ]),
      ),
    freeLab: () => {
      const { world } = content.json('free-lab/lab.json') as { readonly world: string }
      return { world: worldNamed(world), start: content.json('free-lab/start.json') as CardProgram }
    },
    newBlocks: () =>
      newBlocks(
        [...folders().keys()].map((id) => [
          id,
          { start: program(id, 'start')!, solution: program(id, 'solution')! },
        ]),
      ),
    pictureOfCard: (id: string) => {
      const folder = folders().get(id)
      return folder && content.has(folder, 'picture.svg') ? content.path(folder, 'picture.svg') : null
    },
    wrongAnswers: (id: string) =>
      readdirSync(content.path(folderOf(id), 'wrong'))
        .sort()
        .map((file) => basename(file, '.json')),
  }
}
