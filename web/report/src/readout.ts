// The values at the pose shown, as a table.
import { between, Data, number } from "./data";

export class Readout {
  private cells: { cell: HTMLTableCellElement; column: number }[] = [];

  constructor(private data: Data, box: HTMLElement) {
    if (data.readout.length === 0) return;
    const table = document.createElement("table"), head = table.createTHead().insertRow(), body = table.createTBody();
    table.createCaption().textContent = "At the pose shown";
    for (const word of ["coordinate", "position", "", "rate", "", "acceleration", ""]) {
      const cell = document.createElement(word ? "th" : "td");
      cell.textContent = word;
      if (word && word !== "coordinate") cell.className = "n";
      if (word) cell.scope = "col";
      head.append(cell);
    }
    for (const triple of data.readout) this.addRow(body.insertRow(), triple);
    box.append(table);
    box.hidden = false;
  }

  private addRow(row: HTMLTableRowElement, triple: number[]): void {
    const name = document.createElement("th");
    name.scope = "row";
    name.textContent = this.data.columns[triple[0]].name;
    row.append(name);
    for (const column of triple) {
      const cell = row.insertCell();
      cell.className = "n";
      cell.dataset.column = this.data.columns[column].name;
      this.cells.push({ cell, column });
      row.insertCell().textContent = this.data.columns[column].unit;
    }
  }

  show(at: number): void {
    for (const { cell, column } of this.cells) cell.textContent = number(between(this.data.columns[column].values, at));
  }
}
