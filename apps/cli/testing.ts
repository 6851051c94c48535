import { call } from './call.ts'

/** Calls the command line as a teacher would, in this process and in English. */
export async function botgarten<Report = { [key: string]: unknown }>(...args: string[]) {
  const answer = await call(args, 'en')
  return { ...answer, json: () => JSON.parse(answer.stdout) as Report }
}
