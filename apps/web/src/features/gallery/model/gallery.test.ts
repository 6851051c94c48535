import { describe, expect, it, vi } from 'vitest'
import type { Ask, Reply } from '#storage/ask.ts'
import { friendship } from '#storage/testing/sample.ts'
import { Gallery } from './gallery.svelte.ts'

const itemOf = (at: number) => ({
  ...{ id: `item-${at}`, title: `Title ${at}`, card: null, at, by: 'Eule', own: false, brain: true },
  ...{ photo: false, hidden: false, waiting: false, hearts: 0, mine: false, from: null },
  world: friendship.world,
})

/** A class with so many things, a page of 24 at a time. */
function classWith(count: number) {
  const all = Array.from({ length: count }, (_, at) => itemOf(at))
  const asked: string[] = []
  let refusal: Reply | null = null
  const done = (body: unknown): Reply => ({ kind: 'done', body })
  const ask: Ask = (method, path) => {
    asked.push(`${method} ${path}`)
    if (refusal) return Promise.resolve(refusal)
    const from = Number(/from=(\d+)/.exec(path)?.[1])
    if (path.startsWith('/gallery?'))
      return Promise.resolve(done({ total: all.length, items: all.slice(from, from + 24) }))
    if (path.endsWith('/heart')) return Promise.resolve(done({ hearts: 1, mine: true }))
    return Promise.resolve(done({ ...all[0], chain: [], project: friendship }))
  }
  return { all, asked, gallery: new Gallery(ask), refuse: (reply: Reply) => void (refusal = reply) }
}

describe('a gallery', () => {
  it('comes a page at a time; what comes twice because something was shared meanwhile stands there once', async () => {
    const { gallery, all } = classWith(60)
    await gallery.show()
    expect([gallery.items!.length, gallery.hasMore]).toEqual([24, true])
    all.unshift(itemOf(100))
    await gallery.more()
    expect(new Set(gallery.items!.map(({ id }) => id)).size).toBe(gallery.items!.length)
    await gallery.more()
    expect(gallery.hasMore).toBe(false)
  })

  it('ends where things were taken out meanwhile', async () => {
    const { gallery, all } = classWith(30)
    await gallery.show()
    all.length = 20
    await gallery.more()
    expect(gallery.hasMore).toBe(false)
  })

  it('is looked at again soon after somebody has done something, as far as it is shown, once for much', async () => {
    vi.useFakeTimers()
    const { gallery, all, asked } = classWith(60)
    await gallery.show()
    await gallery.more()
    await gallery.look('item-3')
    all.splice(0, 1)
    all[2] = { ...all[2]!, hearts: 5 }
    all.unshift(itemOf(100))
    asked.length = 0
    for (let news = 0; news < 9; news++) gallery.lookSoon()
    await vi.advanceTimersByTimeAsync(2000)
    expect(asked).toEqual(['GET /gallery?by=newest&from=0', 'GET /gallery?by=newest&from=24'])
    expect(gallery.items!.slice(0, 2).map(({ id }) => id)).toEqual(['item-100', 'item-1'])
    expect(gallery.items).toHaveLength(48)
    vi.useRealTimers()
  })

  it('shows a heart in the list and beside it', async () => {
    const { gallery } = classWith(3)
    await gallery.show()
    await gallery.look('item-0')
    await gallery.heart(gallery.items![0]!)
    expect(gallery.items![0]).toMatchObject({ hearts: 1, mine: true })
    expect(gallery.opened).toMatchObject({ hearts: 1, mine: true })
  })

  it('that the teacher has closed is empty and says so; out of reach it keeps what is there', async () => {
    const { gallery, refuse } = classWith(3)
    await gallery.show()
    refuse({ kind: 'away' })
    await gallery.show('hearts')
    expect([gallery.problem, gallery.items!.length]).toEqual(['away', 3])
    refuse({ kind: 'refused', status: 403, code: 'galleryOff', facts: {} })
    await gallery.show('newest')
    expect([gallery.problem, gallery.items]).toEqual(['off', null])
  })

  it('opens nothing where the shared thing is gone, and looks at the list again', async () => {
    const { gallery, asked, refuse } = classWith(3)
    await gallery.show()
    await gallery.look('item-0')
    refuse({ kind: 'refused', status: 404, code: 'noSuchShared', facts: {} })
    asked.length = 0
    await gallery.look('item-1')
    expect([gallery.opened, gallery.problem]).toEqual([null, 'gone'])
    expect(asked).toEqual(['GET /gallery/item-1', 'GET /gallery?by=newest&from=0'])
  })

  it('that the teacher closes while it is open is empty at the next look', async () => {
    vi.useFakeTimers()
    const { gallery, refuse } = classWith(3)
    await gallery.show()
    refuse({ kind: 'refused', status: 403, code: 'galleryOff', facts: {} })
    gallery.lookSoon()
    await vi.advanceTimersByTimeAsync(2000)
    expect([gallery.problem, gallery.items]).toEqual(['off', null])
    vi.useRealTimers()
  })

  it('asks for a heart to be given, and for one that was given to be taken away', async () => {
    const asked: unknown[] = []
    const gallery = new Gallery((_method, _path, body) => {
      asked.push(body)
      return Promise.resolve<Reply>({ kind: 'done', body: { hearts: 0, mine: false } })
    })
    await gallery.heart({ id: 'item-0', mine: false })
    await gallery.heart({ id: 'item-0', mine: true })
    expect(asked).toEqual([{ on: true }, { on: false }])
  })

  it('shows hearts that others have given meanwhile next to what is open', async () => {
    vi.useFakeTimers()
    const { gallery, all } = classWith(3)
    await gallery.show()
    await gallery.look('item-0')
    all[0] = { ...all[0]!, hearts: 7, mine: true }
    gallery.lookSoon()
    await vi.advanceTimersByTimeAsync(2000)
    expect(gallery.opened).toMatchObject({ hearts: 7, mine: true })
    vi.useRealTimers()
  })

  it('closes what is taken out, also where it was gone already; where that fails it stays open', async () => {
    const { gallery, refuse } = classWith(3)
    await gallery.show()
    await gallery.look('item-0')
    refuse({ kind: 'away' })
    await gallery.takeOut('item-0')
    expect([gallery.problem, gallery.opened?.id]).toEqual(['away', 'item-0'])
    const again = classWith(3)
    await again.gallery.show()
    await again.gallery.look('item-0')
    await again.gallery.takeOut('item-0')
    expect([again.gallery.problem, again.gallery.opened]).toEqual([null, null])
  })
})
