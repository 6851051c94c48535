import { meOf } from '../joining/me.ts'
import { openAskingOf } from '../questionnaires/askings-store.ts'
import type { Pupil } from '../joining/sessions-store.ts'
import { askedBy, askedOf } from '../asking/peers-store.ts'
import type { Ports } from '../ports.ts'
import { markOf } from '../projects/marks-store.ts'
import { shownPair } from '../together/shown.ts'
import { handoutsOf } from './handouts-store.ts'

/** All that a pupil's page shows of the class: who, what is free, attention, who looks inside, what was sent, who asks. */
export async function liveOfPupil(ports: Ports, pupil: Pupil) {
  const me = await meOf(ports, pupil)
  // Before the pictures are shown nothing of what was sent is read.
  const asking = await openAskingOf(ports.database.answers.db, pupil.class)
  const handouts = pupil.fresh ? await handoutsOf(ports.database.db, pupil.id) : []
  const asks = pupil.fresh && me.class.asking
  return {
    ...me,
    /** What this pupil has asked a classmate, and what classmates ask. */
    asked: (asks && (await askedBy(ports.database.db, pupil.id))) || null,
    questions: asks ? await askedOf(ports.database.db, pupil.id) : [],
    /** The classmate with whom this pupil works on one program, or who asks to. */
    pair: pupil.fresh ? await shownPair(ports.database.db, pupil.id) : null,
    attention: ports.live.attentionOf(pupil.class),
    inside: ports.live.insideOf(pupil.id),
    handouts,
    /** Of the last change of its projects: a page that saw another one asks for the list of projects. */
    mark: await markOf(ports.database.db, pupil.id),
    /** The form that the class is asked now, by its key. */
    asking: asking?.key ?? null,
  }
}
