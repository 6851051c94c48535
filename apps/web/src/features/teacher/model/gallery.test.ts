import { expect, test } from 'vitest'
import { ClassApi } from './api.ts'
import { ClassGallery } from './gallery.svelte.ts'

const item = (id: string) => ({
  ...{ id, title: `Bo ${id}`, card: null, at: 0, by: 'Fuchs', own: false, brain: false, photo: false },
  ...{ hidden: false, waiting: false, hearts: 0, mine: false, world: {}, from: null },
})

/** A gallery with a list that a test changes between two pages. */
function galleryOf(list: { ids: readonly string[] }, size = 2) {
  const api = new ClassApi((path) => {
    const from = Number(new URL(path, 'http://lab.test').searchParams.get('from'))
    const items = list.ids.slice(from, from + size).map(item)
    const switches = { on: true, asking: false, together: false, waiting: 0 }
    return Promise.resolve(Response.json({ ...switches, total: list.ids.length, items }))
  })
  return new ClassGallery(api, 'class-1')
}
const idsOf = ({ items }: ClassGallery) => items.map(({ id }) => id)

test('a gallery is read page by page until everything is there', async () => {
  const gallery = galleryOf({ ids: ['a', 'b', 'c'] })
  await gallery.show()
  expect([idsOf(gallery), gallery.hasMore]).toEqual([['a', 'b'], true])
  await gallery.more()
  expect([idsOf(gallery), gallery.hasMore]).toEqual([['a', 'b', 'c'], false])
})

test('a list that became shorter meanwhile has no more', async () => {
  const list = { ids: ['a', 'b', 'c'] }
  const gallery = galleryOf(list)
  await gallery.show()
  list.ids = ['a']
  await gallery.more()
  expect([idsOf(gallery), gallery.hasMore]).toEqual([['a', 'b'], false])
})
