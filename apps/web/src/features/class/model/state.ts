import * as v from 'valibot'

const schema = v.object({ firstTeacher: v.nullable(v.object({})) })

/** Can classes be joined here? Only a server with a teacher answers so; a web space and a lab without a class do not. */
export async function hasClasses(): Promise<boolean> {
  if (__WEB_SPACE__) return false
  try {
    const answer = await fetch('/api/class/state')
    if (answer.status !== 200) return false
    const found = v.safeParse(schema, await answer.json())
    return found.success && found.output.firstTeacher !== null
  } catch {
    return false
  }
}
