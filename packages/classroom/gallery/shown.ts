import type { Db } from '../database/database.ts'
import { assetsOfShared, madeBy, type Row, type Viewer } from './shared-store.ts'

/** What something was made from. Null where it is gone or out of sight: "somebody". */
interface Ancestor {
  readonly id: string
  readonly title: string | null
  readonly by: string | null
  readonly own: boolean
}

const idsIn = ({ chain }: Pick<Row, 'chain'>): readonly string[] => JSON.parse(chain) as string[]

/** By id what the viewer may know of it. */
async function ancestors(db: Db, viewer: Viewer, ids: readonly string[]) {
  const found = new Map((await madeBy(db, viewer, [...new Set(ids)])).map((one) => [one.id, one]))
  return (id: string): Ancestor => {
    const { title = null, nickname = null, pupil } = found.get(id) ?? {}
    return { id, title, by: nickname, own: viewer.pupil !== null && pupil === viewer.pupil }
  }
}

const cardOf = (row: Row, { pupil }: Viewer, from: Ancestor | null) => ({
  ...{ id: row.id, title: row.title, card: row.card, at: row.at },
  ...{ by: row.nickname, own: row.pupil === pupil },
  ...{
    brain: row.brain === 1,
    photo: (row.photos ?? 0) > 0,
    hidden: row.hidden === 1,
    waiting: row.waiting === 1,
  },
  ...{ hearts: row.hearts ?? 0, mine: (row.mine ?? 0) > 0 },
  world: JSON.parse(row.world) as unknown,
  from,
})

/** A page of the gallery as pages show it: with what each was made from last. */
export async function shownRows(db: Db, viewer: Viewer, rows: readonly Row[]) {
  const last = (row: Row) => idsIn(row).at(-1)
  const ancestorOf = await ancestors(
    db,
    viewer,
    rows.flatMap((row) => last(row) ?? []),
  )
  return rows.map((row) => {
    const id = last(row)
    return cardOf(row, viewer, id === undefined ? null : ancestorOf(id))
  })
}

/** One of it with its chain, and its project: with titles, and no nickname in it. */
export async function shownOne(db: Db, viewer: Viewer, row: Row & { readonly document: string }) {
  const ids = idsIn(row)
  const ancestorOf = await ancestors(db, viewer, ids)
  const chain = ids.map(ancestorOf)
  const madeFrom = chain.map(({ id, title }) => ({ id, title: title ?? '' }))
  const project = {
    ...(JSON.parse(row.document) as object),
    name: row.title,
    assets: await assetsOfShared(db, row.id),
    ...(madeFrom.length > 0 && { madeFrom }),
  }
  return { ...cardOf(row, viewer, chain.at(-1) ?? null), chain, project }
}
