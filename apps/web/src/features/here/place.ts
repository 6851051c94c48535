import * as v from 'valibot'

const answer = v.object({
  announced: v.nullable(v.pipe(v.string(), v.url())),
  folder: v.nullable(v.string()),
  otherDevice: v.nullable(v.number()),
})

/** How the server on this machine is reached, where it keeps things, and when another device last came. */
export type Place = v.InferOutput<typeof answer>

type Fetch = (path: string) => Promise<Response>

/** null: this is not the machine that serves, or nobody answers. */
export async function placeHere(fetch: Fetch = globalThis.fetch): Promise<Place | null> {
  const response = await fetch('/here.json').catch(() => null)
  if (response?.status !== 200) return null
  const read = v.safeParse(answer, await response.json().catch(() => null))
  return read.success ? read.output : null
}
