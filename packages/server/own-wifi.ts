import { existsSync, readFileSync } from 'node:fs'
import * as v from 'valibot'

const wifi = v.object({ name: v.string(), password: v.string() })

/** The hot spot that this machine makes: `BOTGARTEN_WIFI` names a file of what started it, `{"name", "password"}`. */
export function ownWifi(env: NodeJS.ProcessEnv): v.InferOutput<typeof wifi> | null {
  const file = env['BOTGARTEN_WIFI']
  return file && existsSync(file) ? v.parse(wifi, JSON.parse(readFileSync(file, 'utf8'))) : null
}
