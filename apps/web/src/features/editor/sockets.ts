import type * as Blockly from 'blockly/core'
import type { RobotConfig } from '@botgarten/simulation'

// What is plugged into the robot that a workspace's program drives: new neurons take ports that fit.
const known = new WeakMap<Blockly.Workspace, RobotConfig>()

export const knowRobot = (workspace: Blockly.Workspace, config: RobotConfig): void => {
  known.set(workspace, config)
}
export const robotOf = (workspace: Blockly.Workspace): RobotConfig | undefined => known.get(workspace)
