import { askedBy } from '../asking/peers-store.ts'
import type { Db } from '../database/database.ts'
import { heartsOf, sharedOf } from '../gallery/about-pupil-store.ts'
import { sentTo } from '../live/handouts-store.ts'
import { projectsOf, textOfVersion, thrownOf, versionsOf } from '../projects/projects-store.ts'
import { formsOpenedBy } from '../questionnaires/tokens-store.ts'
import { pairsOf } from '../together/pairs-store.ts'
import { resultsOfPupil } from './results-store.ts'
import { arrayOf, textsOf } from './streamed.ts'

interface Named {
  readonly id: string
  readonly nickname: string
  readonly joinedAt: number
}

/** Each version of the projects of a pupil as JSON, with its pictures. The class deletes the versions of a project in the bin. */
async function* versionsIn(db: Db, pupil: string) {
  for (const { id } of await projectsOf(db, pupil))
    for (const { revision } of await versionsOf(db, pupil, id)) {
      const text = await textOfVersion(db, pupil, id, revision, { id })
      // It may have gone in the meantime.
      if (text !== null) yield text
    }
}

/** The newest version of each project that is not in the bin, as JSON. */
export async function* newestIn(db: Db, pupil: string) {
  for (const { id } of await projectsOf(db, pupil)) {
    const text = await textOfVersion(db, pupil, id, undefined, { id })
    if (text !== null) yield text
  }
}

/** The complete data of a pupil, for the parents: pieces of one JSON text. One version at a time is in memory. */
export async function* allAbout(db: Db, { id, nickname, joinedAt }: Named): AsyncGenerator<string> {
  const thrown = await thrownOf(db, id)
  const small = {
    ...{ nickname, joinedAt, results: await resultsOfPupil(db, id), hearts: await heartsOf(db, id) },
    ...{
      pairs: await pairsOf(db, id),
      asked: (await askedBy(db, id)) ?? null,
      questionnaires: await formsOpenedBy(db, id),
      bin: thrown.map((one) => one.id),
    },
  }
  yield JSON.stringify(small).slice(0, -1)
  const parts = {
    projects: newestIn(db, id),
    versions: versionsIn(db, id),
    sent: textsOf(sentTo(db, id)),
    shared: sharedOf(db, id),
  }
  for (const [name, items] of Object.entries<AsyncIterable<string>>(parts)) {
    yield `,"${name}":`
    yield* arrayOf(items)
  }
  yield '}'
}
