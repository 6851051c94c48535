import type { Ports } from '../ports.ts'
import { allClasses } from '../teaching/clearing-store.ts'
import { settle } from './answers-store.ts'
import { askedClasses, classesToSettle, forgetClass } from './askings-store.ts'
import { chanceOf } from './chance.ts'

/** Closes what nobody has looked at since, and deletes answers of classes that are no more. */
export async function settleAll({ database, steady, random }: Ports): Promise<void> {
  const { answers, db } = database
  for (const id of await classesToSettle(answers.db, steady()))
    await settle(answers, id, steady(), chanceOf(random))
  const there = new Set(await allClasses(db))
  const gone = (await askedClasses(answers.db)).filter((id) => !there.has(id))
  for (const id of gone) await forgetClass(answers.db, id)
  if (gone.length > 0) await answers.vacuum()
}
