import * as v from 'valibot'
import type { Wifi } from '../database/tables.ts'
import { route, type Answer, type Call, type Route } from '../route.ts'
import { removeWifi, setWifi, wifiOf } from './wifi-store.ts'

/** As IEEE 802.11 has them: a name of 1 to 32 bytes; none, or 8 to 63 letters of ASCII as WPA's passphrase. */
const wifi = v.strictObject({
  // eslint-disable-next-line no-control-regex -- these are what a name may not hold
  name: v.pipe(v.string(), v.trim(), v.minLength(1), v.maxBytes(32), v.regex(/^[^\x00-\x1f\x7f]*$/)),
  password: v.pipe(v.string(), v.regex(/^([\x20-\x7e]{8,63})?$/)),
})

/** Where the teacher has named none, the Wi-Fi of the machine itself is the one of the room. */
async function shown({ ports, who }: Call<undefined>): Promise<Answer> {
  return { body: { wifi: (await wifiOf(ports.database.db, who.class!.teacher)) ?? ports.host.wifi } }
}

/** For all classes of this teacher: they meet in the same rooms. */
async function change({ ports, who, body }: Call<Wifi>): Promise<Answer> {
  await setWifi(ports.database.db, who.class!.teacher, body)
  return {}
}

async function remove({ ports, who }: Call<undefined>): Promise<Answer> {
  await removeWifi(ports.database.db, who.class!.teacher)
  return {}
}

export const wifiRoutes: readonly Route[] = [
  route('GET', '/classes/:class/wifi', ['owner', 'substitute'], shown),
  route('PUT', '/classes/:class/wifi', ['owner'], change, wifi),
  route('DELETE', '/classes/:class/wifi', ['owner'], remove),
]
